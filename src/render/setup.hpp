#pragma once
#include <shading.hpp>
#include <vec3.hpp>

#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// All that is chosen about how a scene is traced and shaded; the scene file stays as it is. `parameters()` lists it.
struct Setup {
    Options options;
    Shading<double> shading;
    Vec3<double> light_vector;
    double light_intensity = 1;

    bool operator==(const Setup&) const = default;
};

/// As the scene file says it.
Setup setup_of(const Scene& scene);

/// The scene as the setup says it.
Scene applied(Scene scene, const Setup& setup);

}  // namespace glassbox
