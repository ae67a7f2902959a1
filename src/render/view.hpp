#pragma once
#include <span>
#include <variant>

#include <filter.hpp>
#include <turn.hpp>
#include <viewing_plane.hpp>

#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// A pinhole view whose plane is relative to the eye: a ray's direction is a point of the plane, and loses no digit to
/// the eye's coordinates.
struct FromEye {
    ViewingPlane<double> plane;
    Vec3<double> eye;
};

inline Ray<double> pixel_ray(const FromEye& view, double j, double i) {
    return {view.eye, pixel_ray(Pinhole<double>{view.plane, {}}, j, i).D};
}

/// A scene's viewing plane, and the origin of its rays.
using View = std::variant<Parallel<double>, FromEye>;

/// The scene's view after the turns, rebuilt from the start: neighbours about the same axis become one turn by the sum
/// of their angles, so that 36 turns by 10° are none at all.
View rebuilt_view(const Scene& scene, std::span<const Turn<double>> turns);

/// The scene's view after one turn after another, each rounded, as in a program that rotates its points at every key
/// press.
View accumulated_view(const Scene& scene, std::span<const Turn<double>> turns);

/// The turns that the stage knows: none before the fifth.
std::span<const Turn<double>> turns_of(const Options& options);

/// The scene's view as the options say. All code that traces pixels' rays uses it.
View view(const Scene& scene, const Options& options);

/// The ray of the pixel (x, y) of a picture `height` pixels high; y counts down from the top.
inline Ray<double> pixel_ray(const View& view, int x, int y, int height) {
    return std::visit([&](const auto& v) { return pixel_ray(v, x, height - 1 - y); }, view);
}

/// The bounds of all rays of a picture. Each coordinate of a pixel's ray is monotone from column to column and from row
/// to row, rounding included: its extremes are at the corners.
inline RayBounds reach(const View& view, int width, int height) {
    RayBounds all;
    for (const int x : {0, width - 1})
        for (const int y : {0, height - 1}) all = including(all, pixel_ray(view, x, y, height));
    return all;
}

/// The same scene as a picture of another size. The vertical extent of the view stays, pixels keep their shape, and a
/// wider or narrower picture gains or loses the same on both sides.
Scene resized(Scene scene, int width, int height);

}  // namespace glassbox
