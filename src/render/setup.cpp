#include "render/setup.hpp"

namespace glassbox {

Setup setup_of(const Scene& scene) { return {{}, scene.shading, scene.light_vector, scene.light_intensity}; }

Scene applied(Scene scene, const Setup& setup) {
    scene.shading = setup.shading;
    scene.light_vector = setup.light_vector;
    scene.light_intensity = setup.light_intensity;
    return scene;
}

}  // namespace glassbox
