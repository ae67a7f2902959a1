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

/// Calls `use(x, y)` with the first pixel of each square of the range.
template <class Columns, class Rows, class Use>
void for_each_square(const Columns& columns, const Rows& rows, int side, const Use& use) {
    for (int y = rows.begin(); y < rows.end(); y += side)
        for (int x = columns.begin(); x < columns.end(); x += side) use(x, y);
}

/// Finds the nearest hits of all pixels' rays, many at a time, and calls `each(x, y, surface, t)` once for every pixel,
/// on the job's threads. `surface` is engine::no_surface where the ray meets none, and engine::not_told where the
/// pixel's ray must be traced by itself, or is better: see too_fine.hpp. t is accurate to about five digits of the size
/// of the scene, if doubles can distinguish neighbouring rays and t does not grow much within a tile. Throws Cancelled.
template <class Each>
void trace_tiles(const engine::Engine& engine, const View& view, int width, int height, const Job& job,
                 const Each& each) {
    constexpr int side = engine::tile_side;
    const std::optional<engine::Grid> rays = grid_for(view, width, height, engine);
    const double per_t_scale = rays ? 1 / rays->t_scale : 1;
    for_each_block(width, height, job, [&](const auto& columns, const auto& rows) {
        engine::Tile tile, untold{};
        std::fill(std::begin(untold.surface), std::end(untold.surface), engine::not_told);
        for_each_square(columns, rows, side, [&](int x0, int y0) {
            throw_if_stopped(job);
            const int x1 = std::min(x0 + side, columns.end()), y1 = std::min(y0 + side, rows.end());
            const Ray<double> middle = pixel_ray(view, (x0 + x1) / 2, (y0 + y1) / 2, height);
            const bool together = rays && !meets_too_fine(engine, view, middle);
            const int bottom = height - y0 - side;  // the tile's lowest row, which may lie below the picture
            if (together) engine::trace_tile(engine, *rays, x0, bottom, tile);
            const engine::Tile& told = together ? tile : untold;
            for (int y = y0; y < y1; ++y)
                for (int x = x0; x < x1; ++x) {
                    const std::uint32_t at = engine::place_in_tile(static_cast<std::uint32_t>(x - x0),
                                                                   static_cast<std::uint32_t>(y0 + side - 1 - y));
                    each(x, y, told.surface[at], static_cast<double>(told.t[at]) * per_t_scale);
                }
        });
        if (job.done) *job.done += static_cast<std::int64_t>(rows.size() * columns.size());
    });
}

}  // namespace glassbox
