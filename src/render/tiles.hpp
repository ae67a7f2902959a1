#pragma once
#include <algorithm>
#include <optional>
#include <variant>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/too_fine.hpp"
#include "render/view.hpp"

namespace glassbox {

/// A view's rays as the engine traces many of them together; nothing where its bounds fail.
inline std::optional<engine::Grid> grid_for(const View& view, int width, int height, const engine::Engine& engine) {
    if (const auto* from_eye = std::get_if<FromEye>(&view))
        return engine::grid(from_eye->eye, from_eye->plane, width, height, engine);
    return engine::grid(std::get<Parallel<double>>(view), width, height, engine);
}

/// How many tiles there are along a side of a picture.
inline int tiles_on(int pixels) { return (pixels + engine::tile_side - 1) / engine::tile_side; }

/// Finds the nearest hits of all pixels' rays, many at a time, and calls `each(x, y, surface, t)` once for every pixel,
/// on the job's threads. `surface` is engine::no_surface where the ray meets none, and engine::not_told where the
/// pixel's ray must be traced by itself, or is better: see too_fine.hpp and engine::most_leaves. t is accurate to about
/// five digits of the size of the scene, if doubles can distinguish neighbouring rays and t does not grow much within a
/// tile. Throws Cancelled.
template <class Each>
void trace_tiles(const engine::Engine& engine, const View& view, int width, int height, const Job& job,
                 const Each& each) {
    constexpr int side = engine::tile_side;
    const std::optional<engine::Grid> rays = grid_for(view, width, height, engine);
    const double per_t_scale = rays ? 1 / rays->t_scale : 1;
    const tbb::blocked_range2d<int> tiles(0, tiles_on(height), 1, 0, tiles_on(width), 4);
    run_parallel(tiles, job, [&](const auto& some) {
        engine::Tile tile, untold{};
        std::fill(std::begin(untold.surface), std::end(untold.surface), engine::not_told);
        bool was_quick = false;  // whether the last tile tested few leaves
        for (int row = some.rows().begin(); row != some.rows().end(); ++row)
            for (int column = some.cols().begin(); column != some.cols().end(); ++column) {
                throw_if_stopped(job);
                const int x0 = column * side, y0 = row * side;
                const int x1 = std::min(x0 + side, width), y1 = std::min(y0 + side, height);
                const auto middle = [&] { return pixel_ray(view, (x0 + x1) / 2, (y0 + y1) / 2, height); };
                const bool together = rays && (was_quick || !meets_too_fine(engine, view, middle()));
                const int bottom = height - y0 - side;  // the tile's lowest row, which may lie below the picture
                if (together) engine::trace_tile(engine, *rays, x0, bottom, tile);
                was_quick = together && tile.leaves < engine::most_leaves / 2;
                const engine::Tile& told = together ? tile : untold;
                for (int y = y0; y < y1; ++y)
                    for (int x = x0; x < x1; ++x) {
                        const std::uint32_t at = engine::place_in_tile(static_cast<std::uint32_t>(x - x0),
                                                                       static_cast<std::uint32_t>(y0 + side - 1 - y));
                        each(x, y, told.surface[at], static_cast<double>(told.t[at]) * per_t_scale);
                    }
                if (job.done) *job.done += std::int64_t{y1 - y0} * (x1 - x0);
            }
    });
}

}  // namespace glassbox
