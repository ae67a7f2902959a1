#include "viewer/model/space/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace glassbox {

namespace {

constexpr double field_of_view = 30;  // degrees, of the screen's smaller side
constexpr double near_part = 1e-3;    // nearer points are not drawn: a part of the camera's distance

double radians(double degrees) { return degrees * (std::numbers::pi / 180); }

double depth_of(const Camera& camera, const Vec3<double>& point) {
    return camera.distance - dot(point - camera.middle, camera.back);
}

/// The part [first, second] of a line from 0 to 1 where value_0 + s (value_1 − value_0) ≥ 0.
bool cut(std::pair<double, double>& part, double value_0, double value_1) {
    if (value_0 < 0 && value_1 < 0) return false;
    const double s = value_0 / (value_0 - value_1);
    if (value_0 < 0) part.first = std::max(part.first, s);
    if (value_1 < 0) part.second = std::min(part.second, s);
    return part.first < part.second;
}

Vec3<double> towards_viewer(const Parallel<double>& v) { return -unit(v.direction); }
Vec3<double> towards_viewer(const FromEye& v) { return unit(cross(v.plane.right, v.plane.up)); }

}  // namespace

Upright upright(const View& view) {
    const auto [plane_up, back] =
        std::visit([](const auto& v) { return std::pair(v.plane.up, towards_viewer(v)); }, view);
    const std::array<Vec3<double>, 3> axes{{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}};
    Vec3<double> up = axes[0];
    for (const Vec3<double>& axis : axes)
        if (std::abs(dot(axis, plane_up)) > std::abs(dot(up, plane_up)) * (1 + 1e-9)) up = axis;
    if (dot(up, plane_up) < 0) up = -up;
    const Vec3<double> level = back - dot(back, up) * up;
    // A parallel view may look along its own up.
    const Vec3<double> other = up == axes[2] ? axes[1] : axes[2];
    return {up, length(level) > 1e-6 ? unit(level) : other};
}

Camera camera(const Orbit& orbit, const Ball& sight, const Upright& upright, Point area) {
    const Vec3<double> side = cross(upright.up, upright.front);
    const auto [cos_a, sin_a] = std::pair(std::cos(radians(orbit.azimuth)), std::sin(radians(orbit.azimuth)));
    const auto [cos_e, sin_e] = std::pair(std::cos(radians(orbit.elevation)), std::sin(radians(orbit.elevation)));
    const Vec3<double> level = cos_a * upright.front + sin_a * side;
    Camera result;
    result.middle = sight.center;
    result.back = cos_e * level + sin_e * upright.up;
    result.right = cross(upright.up, level);
    result.up = cross(result.back, result.right);
    const double half = radians(field_of_view / 2);
    result.distance = sight.radius / std::sin(half) * orbit.distance;
    result.focal = std::min(area.x, area.y) / 2 / std::tan(half);
    result.center = {area.x * (.5 + orbit.pan.x), area.y * (.5 + orbit.pan.y)};
    result.area = area;
    return result;
}

namespace {

/// How much larger, and shifted by how much, the points fill the screen but for a margin.
struct Enlargement {
    double factor = 1;
    Point shift;
};

Enlargement filling(const Camera& camera, std::span<const Vec3<double>> points) {
    constexpr double used = .86, most = 6;  // of the pane, for words stand beside points; how much larger
    Point least{1e30, 1e30}, greatest{-1e30, -1e30};
    for (const Vec3<double>& point : points) {
        if (!is_finite(point) || !in_front(camera, point)) continue;
        const Point at = project(camera, point).at;
        least = {std::min(least.x, at.x), std::min(least.y, at.y)};
        greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y)};
    }
    const double width = greatest.x - least.x, height = greatest.y - least.y;
    if (!(width > 0) || !(height > 0)) return {};
    const double factor = std::clamp(std::min(used * camera.area.x / width, used * camera.area.y / height), 1.0, most);
    return {factor,
            {factor * (camera.center.x - (least.x + greatest.x) / 2),
             factor * (camera.center.y - (least.y + greatest.y) / 2)}};
}

}  // namespace

Camera camera_of(const Orbit& orbit, const InPane& shown) {
    const auto& [sight, focus, outline, upright, area] = shown;
    const Orbit whole{.azimuth = orbit.azimuth, .elevation = orbit.elevation};
    const Enlargement enlarged = filling(camera(whole, sight, upright, area), outline);
    // The nearer, the more in the middle is the focus.
    const double towards_focus = std::clamp(1.25 * (1 - orbit.distance), 0.0, 1.0);
    Ball nearer = sight;
    nearer.center = sight.center + towards_focus * (focus - sight.center);
    Camera result = camera(orbit, nearer, upright, area);
    result.focal *= enlarged.factor;
    result.center.x += (1 - towards_focus) * enlarged.shift.x;
    result.center.y += (1 - towards_focus) * enlarged.shift.y;
    return result;
}

Projected project(const Camera& camera, const Vec3<double>& point) {
    const Vec3<double> from_middle = point - camera.middle;
    const double depth = depth_of(camera, point);
    const double scale = camera.focal / depth;
    return {{camera.center.x + scale * dot(from_middle, camera.right),
             camera.center.y - scale * dot(from_middle, camera.up)},
            depth};
}

bool in_front(const Camera& camera, const Vec3<double>& point) {
    return depth_of(camera, point) >= near_part * camera.distance;
}

std::optional<Piece> visible_part(const Camera& camera, const Vec3<double>& from, const Vec3<double>& to) {
    // Before the projection each side of the screen is a plane through the eye: what is inside has values ≥ 0.
    const auto sides = [&](const Vec3<double>& point) {
        const double depth = depth_of(camera, point);
        const double x = camera.focal * dot(point - camera.middle, camera.right);
        const double y = camera.focal * dot(point - camera.middle, camera.up);
        return std::array<double, 5>{depth - near_part * camera.distance,  //
                                     camera.center.x * depth + x, (camera.area.x - camera.center.x) * depth - x,
                                     camera.center.y * depth - y, (camera.area.y - camera.center.y) * depth + y};
    };
    const auto a = sides(from), b = sides(to);
    std::pair<double, double> part{0, 1};
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!cut(part, a[i], b[i])) return {};
    const auto at = [&](double s) { return s == 0 ? from : s == 1 ? to : from + s * (to - from); };
    return Piece{at(part.first), at(part.second)};
}

Vec3<double> eye(const Camera& camera) { return camera.middle + camera.distance * camera.back; }

Ray<double> ray_through(const Camera& camera, Point screen) {
    return {eye(camera), (screen.x - camera.center.x) / camera.focal * camera.right -
                             (screen.y - camera.center.y) / camera.focal * camera.up - camera.back};
}

double length_of_pixel(const Camera& camera, const Vec3<double>& point) {
    return std::max(depth_of(camera, point), near_part * camera.distance) / camera.focal;
}

Orbit dragged(Orbit orbit, Point by, double text_size) {
    const double degrees = 9 / text_size;  // half a degree a pixel at a text size of 18
    orbit.azimuth = std::remainder(orbit.azimuth - by.x * degrees, 360);
    orbit.elevation = std::clamp(orbit.elevation + by.y * degrees, -greatest_elevation, greatest_elevation);
    return orbit;
}

Orbit panned(Orbit orbit, Point by, Point area) {
    orbit.pan.x = std::clamp(orbit.pan.x + by.x / area.x, -2.0, 2.0);
    orbit.pan.y = std::clamp(orbit.pan.y + by.y / area.y, -2.0, 2.0);
    return orbit;
}

Orbit closer(Orbit orbit, double factor) {
    orbit.distance = std::clamp(orbit.distance * factor, least_distance, greatest_distance);
    return orbit;
}

}  // namespace glassbox
