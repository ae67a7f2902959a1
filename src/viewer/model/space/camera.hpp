#pragma once
#include <optional>
#include <span>
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

/// Which way is up in a scene, and from where its picture is seen: two perpendicular unit vectors.
struct Upright {
    Vec3<double> up, front;
};

/// Up is the axis of the world that the picture's own up is closest to (z where two are equally close).
Upright upright(const View& view);

/// A perspective camera. `right`, `up` and `back` are unit vectors, right × up = back.
struct Camera {
    Vec3<double> middle;           ///< what is looked at; shown at `center`
    Vec3<double> right, up, back;  ///< on the screen, and from the middle to the eye
    double distance = 1;           ///< from the eye to the middle
    double focal = 1;              ///< how many screen pixels a unit length at distance 1 covers
    Point center, area;            ///< of the screen, in pixels from its top left
};

/// Returns the camera that sees all of the ball if `orbit.distance` is 1. Azimuth 0 is the picture's own side; the
/// azimuth counts counter-clockwise as seen from above, the elevation upwards.
Camera camera(const Orbit& orbit, const Ball& sight, const Upright& upright, Point area);

/// What a pane shows of the scene in space.
struct InPane {
    Ball sight;
    Vec3<double> focus;                     ///< what coming closer leads to
    std::span<const Vec3<double>> outline;  ///< points that fill the pane at distance 1
    Upright upright;
    Point area;  ///< of the pane
};

/// Returns the camera of a pane: like `camera`, but enlarged and shifted so that at distance 1 the outline fills the
/// pane.
Camera camera_of(const Orbit& orbit, const InPane& shown);

/// Where a point is on the screen, and its depth in front of the eye, measured along the camera's axis.
struct Projected {
    Point at;
    double depth = 0;
};

/// The point must be in front of the eye: see `in_front`.
Projected project(const Camera& camera, const Vec3<double>& point);

/// Whether the point is far enough in front of the eye to be projected.
bool in_front(const Camera& camera, const Vec3<double>& point);

/// The part of a line that is in front of the eye and, projected, on the screen; none if there is none.
using Piece = std::pair<Vec3<double>, Vec3<double>>;
std::optional<Piece> visible_part(const Camera& camera, const Vec3<double>& from, const Vec3<double>& to);

Vec3<double> eye(const Camera& camera);

/// Returns the ray from the eye through a point of the screen; t is the depth.
Ray<double> ray_through(const Camera& camera, Point screen);

/// Returns the length of one screen pixel at that point.
double length_of_pixel(const Camera& camera, const Vec3<double>& point);

/// Returns the orbit after the mouse was dragged by that many pixels; `text_size` tells how large a pixel is.
Orbit dragged(Orbit orbit, Point by, double text_size);

/// Returns the orbit after everything was shifted by that many pixels of a pane.
Orbit panned(Orbit orbit, Point by, Point area);

/// Returns the orbit at `factor` times the distance, within limits.
Orbit closer(Orbit orbit, double factor);

inline constexpr double least_distance = 1e-3, greatest_distance = 100;
inline constexpr double greatest_elevation = 89;

}  // namespace glassbox
