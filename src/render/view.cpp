#include "render/view.hpp"

namespace glassbox {

namespace {

Parallel<double> seen(const ParallelView& v, int, int) { return {{v.corner, v.right, v.up}, v.direction}; }

Pinhole<double> seen(const PinholeView& v, int width, int height) {
    return looking(v.eye, v.look_at, v.up, v.field_of_view, width, height);
}

}  // namespace

View view(const Scene& scene, std::span<const Turn<double>> turns) {
    const Rotation<double> R = rotation<double>(turns);
    return std::visit([&](const auto& v) -> View { return turned(seen(v, scene.width, scene.height), R, scene.pivot); },
                      scene.view);
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
