#include "viewer/model/setup.hpp"

namespace glassbox {

Setup setup_of(const Scene& scene) { return {{}, scene.shading, scene.light_position, scene.light_intensity}; }

Scene applied(Scene scene, const Setup& setup) {
    scene.shading = setup.shading;
    scene.light_position = setup.light_position;
    scene.light_intensity = setup.light_intensity;
    return scene;
}

Setup with_figure(Setup setup, const Figure& figure) {
    setup.shading.k_a = figure.k_a;
    setup.shading.k_d = figure.k_d;
    setup.shading.k_s = figure.k_s;
    return setup;
}

Setup turned(Setup setup, Axis axis, double degrees) {
    setup.options.turns.push_back({axis, degrees});
    return setup;
}

}  // namespace glassbox
