#pragma once
#include <algorithm>
#include <variant>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/view.hpp"

namespace glassbox {

/// Finds the nearest hits of all pixels' rays, many at a time, and calls `each(x, y, surface, t)` once for every pixel,
/// on the job's threads. `surface` is engine::no_surface where the ray meets none, and engine::not_told where the
/// pixel's ray must be traced by itself. t is accurate to about five digits of the size of the scene, if doubles can
/// distinguish neighbouring rays and t does not grow much within a tile. Throws Cancelled.
template <class Each>
void trace_tiles(const engine::Engine& engine, const View& view, int width, int height, const Job& job,
                 const Each& each) {
    constexpr int side = engine::tile_side;
    const auto* from_eye = std::get_if<FromEye>(&view);
    const auto grid = from_eye ? engine::grid(from_eye->eye, from_eye->plane, width, height, engine)
                               : engine::grid(std::get<Parallel<double>>(view), width, height, engine);
    const tbb::blocked_range2d<int> all(0, height, tile_side, 0, width, tile_side);
    run_parallel(all, job, [&](const auto& part) {
        engine::Tile tile;
        std::fill(std::begin(tile.surface), std::end(tile.surface), engine::not_told);
        for (int y0 = part.rows().begin(); y0 < part.rows().end(); y0 += side)
            for (int x0 = part.cols().begin(); x0 < part.cols().end(); x0 += side) {
                throw_if_stopped(job);
                const int bottom = height - y0 - side;  // the tile's lowest row, which may lie below the picture
                if (grid) engine::trace_tile(engine, *grid, x0, bottom, tile);
                const int y1 = std::min(y0 + side, part.rows().end()), x1 = std::min(x0 + side, part.cols().end());
                for (int y = y0; y < y1; ++y)
                    for (int x = x0; x < x1; ++x) {
                        const int at = engine::place_in_tile(x - x0, height - 1 - y - bottom);
                        each(x, y, tile.surface[at], grid ? engine::t_of_key(*grid, tile.key_low[at]) : 0);
                    }
            }
        if (job.done) *job.done += static_cast<std::int64_t>(part.rows().size() * part.cols().size());
    });
}

}  // namespace glassbox
