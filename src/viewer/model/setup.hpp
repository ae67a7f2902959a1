#pragma once
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// All that the viewer's controls change of how a scene is seen; the scene file stays as it is.
struct Setup {
    Options options;
    Shading<double> shading;
    Vec3<double> light_position;
    double light_intensity = 1;

    bool operator==(const Setup&) const = default;
};

/// As the scene file says it.
Setup setup_of(const Scene& scene);

/// The scene as the setup says it.
Scene applied(Scene scene, const Setup& setup);

/// One of the paper's five figures: which terms it has, as (k_a, k_d, k_s).
struct Figure {
    const char* name;
    double k_a, k_d, k_s;
};
inline constexpr Figure figures[] = {
    {"Ambient", 1, 0, 0}, {"Diffuse", 0, 1, 0}, {"Specular", 0, 0, 1}, {"Specular + diffuse", 0, 1, .2},
    {"Final", .2, 1, .2},
};

/// The same setup with a figure's coefficients.
Setup with_figure(Setup setup, const Figure& figure);

/// The same setup, turned further. A turn about the axis of the last one is added to it.
Setup turned(Setup setup, Axis axis, double degrees);

}  // namespace glassbox
