#include "render/view.hpp"

#include <cmath>
#include <vector>

namespace glassbox {

namespace {

Parallel<double> seen(const ParallelView& v, int, int) { return {{v.corner, v.right, v.up}, v.direction}; }

FromEye seen(const PinholeView& v, int width, int height) {
    return {looking(Vec3<double>{}, v.look_at - v.eye, v.up, v.field_of_view, width, height).plane, v.eye};
}

FromEye turned(const FromEye& v, const Rotation<double>& R, const Vec3<double>& pivot) {
    return {turned(v.plane, R, Vec3<double>{}), turned(v.eye, R, pivot)};
}

View unturned(const Scene& scene) {
    return std::visit([&](const auto& v) -> View { return seen(v, scene.width, scene.height); }, scene.view);
}

View turned_by(const View& view, const Rotation<double>& R, const Vec3<double>& pivot) {
    return std::visit([&](const auto& v) -> View { return turned(v, R, pivot); }, view);
}

/// Adds up neighbours about the same axis, without whole turns. 36 · 10 degrees are 360 exactly; radians would round.
std::vector<Turn<double>> joined(std::span<const Turn<double>> turns) {
    std::vector<Turn<double>> result;
    for (const Turn<double>& turn : turns)
        if (!result.empty() && result.back().axis == turn.axis)
            result.back().degrees = std::remainder(result.back().degrees, 360) + std::remainder(turn.degrees, 360);
        else result.push_back(turn);
    return result;
}

}  // namespace

View rebuilt_view(const Scene& scene, std::span<const Turn<double>> turns) {
    return turned_by(unturned(scene), rotation<double>(joined(turns)), scene.pivot);
}

View accumulated_view(const Scene& scene, std::span<const Turn<double>> turns) {
    View pose = unturned(scene);
    for (const Turn<double>& turn : turns) pose = turned_by(pose, rotation(turn), scene.pivot);
    return pose;
}

std::span<const Turn<double>> turns_of(const Options& options) {
    return options.stage >= 5 ? std::span(options.turns) : std::span<const Turn<double>>{};
}

View view(const Scene& scene, const Options& options) {
    return options.accumulated ? accumulated_view(scene, turns_of(options)) : rebuilt_view(scene, turns_of(options));
}

Scene resized(Scene scene, int width, int height) {
    if (auto* v = std::get_if<ParallelView>(&scene.view)) {
        const double pixel = static_cast<double>(scene.height) / height;
        v->corner = v->corner + (scene.width - width * pixel) / 2 * v->right;
        v->right = pixel * v->right;
        v->up = pixel * v->up;
    }
    scene.width = width;
    scene.height = height;
    return scene;
}

}  // namespace glassbox
