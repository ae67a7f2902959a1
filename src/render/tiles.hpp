#pragma once
#include <algorithm>
#include <optional>
#include <variant>

#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/view.hpp"

namespace glassbox {

/// A view's rays as the engine traces many of them together; nothing where its bounds fail.
inline std::optional<engine::Grid> grid_for(const View& view, int width, int height, const engine::Engine& engine) {
    if (const auto* from_eye = std::get_if<FromEye>(&view))
        return engine::grid(from_eye->eye, from_eye->plane, width, height, engine);
    return engine::grid(std::get<Parallel<double>>(view), width, height, engine);
}

/// Finds the nearest hits of all pixels' rays, many at a time, and calls `each(x, y, surface, t)` once for every pixel,
/// on the job's threads. `surface` is engine::no_surface where the ray meets none, and engine::not_told where the
/// pixel's ray must be traced by itself. t is accurate to about five digits of the size of the scene, if doubles can
/// distinguish neighbouring rays and t does not grow much within a tile. Throws Cancelled.
template <class Each>
void trace_tiles(const engine::Engine& engine, const View& view, int width, int height, const Job& job,
                 const Each& each) {
    constexpr int side = engine::tile_side;
    const std::optional<engine::Grid> rays = grid_for(view, width, height, engine);
    for_each_block(width, height, job, [&](const auto& columns, const auto& rows) {
        engine::Tile tile;
        std::fill(std::begin(tile.surface), std::end(tile.surface), engine::not_told);
        for (int y0 = rows.begin(); y0 < rows.end(); y0 += side)
            for (int x0 = columns.begin(); x0 < columns.end(); x0 += side) {
                throw_if_stopped(job);
                const int bottom = height - y0 - side;  // the tile's lowest row, which may lie below the picture
                if (rays) engine::trace_tile(engine, *rays, x0, bottom, tile);
                const int y1 = std::min(y0 + side, rows.end()), x1 = std::min(x0 + side, columns.end());
                for (int y = y0; y < y1; ++y)
                    for (int x = x0; x < x1; ++x) {
                        const int at = engine::place_in_tile(x - x0, height - 1 - y - bottom);
                        each(x, y, tile.surface[at], rays ? engine::given_t_of_key(*rays, tile.key(at)) : 0);
                    }
            }
        if (job.done) *job.done += static_cast<std::int64_t>(rows.size() * columns.size());
    });
}

}  // namespace glassbox
