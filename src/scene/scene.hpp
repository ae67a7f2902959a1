#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <rgb.hpp>
#include <shading.hpp>
#include <vec3.hpp>

#include "scene/error.hpp"
#include "scene/shared.hpp"

namespace glassbox {

/// Rays that start on the viewing plane; `corner` is the bottom-left pixel's start. The defaults are the paper's.
struct ParallelView {
    Vec3<double> corner{500, 0, 0};
    Vec3<double> right{0, 1, 0};
    Vec3<double> up{0, 0, 1};
    Vec3<double> direction{-1, 0, 0};
};

/// Rays that start at the eye.
struct PinholeView {
    Vec3<double> eye;
    Vec3<double> look_at;
    Vec3<double> up{0, 0, 1};
    double field_of_view = 45;  ///< vertical, degrees
};

struct ColoredSphere {
    Vec3<double> center;
    double radius;
    Rgb color;
};

struct ColoredTriangle {
    std::array<Vec3<double>, 3> vertices;
    Rgb color;
};

/// A surface made of triangles: each face three indices into `vertices`, counter-clockwise.
struct Mesh {
    std::vector<Vec3<double>> vertices;
    std::vector<std::array<std::uint32_t, 3>> faces;
    Rgb color;
    std::string file = {};  ///< that it was read from; empty: none
};

/// An option of the command line, without its dashes, with which the scene's numbers fail.
struct FailingOption {
    std::string name, value;
    Place place;
};

/// The content of a scene file. Surfaces are numbered: spheres first, then triangles, then mesh faces, each in file
/// order. Colours range from 0 to 255.
struct Scene {
    std::string title;

    int width = 500;
    int height = 500;
    Rgb background;
    std::optional<Rgb> border;  ///< one pixel wide, painted over the picture

    std::variant<ParallelView, PinholeView> view;
    Vec3<double> pivot;  ///< the point about which the view turns

    Vec3<double> light_vector{1000, 250, 250};  ///< only its direction from the world's origin counts
    double light_intensity = 1;

    Shading<double> shading{ShadingModel::blinn_phong, 0.2, 1, 0.2, 15, {255, 102, 102}, {255, 255, 255}};

    std::vector<ColoredSphere> spheres;
    std::vector<ColoredTriangle> triangles;
    std::vector<Shared<Mesh>> meshes;

    std::vector<FailingOption> failing;  ///< none: nothing is said to fail
};

/// The largest picture allowed: pixels on a side, and pixels in all.
inline constexpr int max_side = 32768;
inline constexpr std::int64_t max_pixels = std::int64_t{1} << 28;

}  // namespace glassbox
