#pragma once
#include <optional>
#include <utility>

#include <ray.hpp>

#include "render/view.hpp"
#include "viewer/model/state/picture_view.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

/// All points at most `radius` from the centre.
struct Ball {
    Vec3<double> center;
    double radius = 1;
};

/// Which way is up in a scene, and where its picture is looked at from: two unit vectors at right angles.
struct Upright {
    Vec3<double> up, front;
};

/// Up is the axis of the world that the picture's own up is closest to (z where two are equally close).
Upright upright(const View& view);

/// A perspective look at the scene. `right`, `up` and `back` are unit vectors, right × up = back.
struct Camera {
    Vec3<double> middle;           ///< what is looked at; shown at `center`
    Vec3<double> right, up, back;  ///< on the screen, and from the middle to the eye
    double distance = 1;           ///< from the eye to the middle
    double focal = 1;              ///< how many screen pixels a unit length at distance 1 covers
    Point center, area;            ///< of the screen, in pixels from its top left
};

/// The camera that sees all of the ball where `orbit.distance` is 1. Azimuth 0 is the picture's own side; it counts
/// counter-clockwise as seen from above, the elevation upwards.
Camera camera(const Orbit& orbit, const Ball& sight, const Upright& upright, Point area);

/// Where a point is on the screen, and how far before the eye it lies, measured along the camera's axis.
struct Projected {
    Point at;
    double depth = 0;
};

/// The point must lie before the eye: see `in_front`.
Projected project(const Camera& camera, const Vec3<double>& point);

/// Whether the point lies far enough before the eye to be projected.
bool in_front(const Camera& camera, const Vec3<double>& point);

/// The part of a line that lies in front and, projected, on the screen; none if there is none.
using Piece = std::pair<Vec3<double>, Vec3<double>>;
std::optional<Piece> visible_part(const Camera& camera, const Vec3<double>& from, const Vec3<double>& to);

Vec3<double> eye(const Camera& camera);

/// The ray from the eye through a point of the screen; t counts the depth.
Ray<double> ray_through(const Camera& camera, Point screen);

/// How long a length of one screen pixel is at that point.
double length_of_pixel(const Camera& camera, const Vec3<double>& point);

/// The orbit after the mouse was dragged by that many pixels; `text_size` says how large a pixel is.
Orbit dragged(Orbit orbit, Point by, double text_size);

/// The orbit at `factor` times the distance, within limits.
Orbit closer(Orbit orbit, double factor);

inline constexpr double least_distance = 1e-3, greatest_distance = 100;
inline constexpr double greatest_elevation = 89;

}  // namespace glassbox
