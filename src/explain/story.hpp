#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <ray.hpp>
#include <rgb.hpp>
#include <shading.hpp>
#include <vec3.hpp>

#include "explain/replay.hpp"
#include "render/options.hpp"

namespace glassbox {

/// The parts of a pixel's story. All numbers are those that the formulas computed, each with what became of it.
namespace story {

using Number = Checked;

struct Vector {
    Number x, y, z;
};

/// What became of a surface, and why.
enum class Fate {
    nearest,           ///< met, and nothing is met before
    as_near,           ///< met, exactly as near as the nearest, which is listed later
    farther,           ///< met, behind the nearest
    apart,             ///< a sphere that the line does not touch: Δ < 0
    touched,           ///< a sphere that the line only touches, Δ = 0, by the rule of the paper's program
    from_inside,       ///< a sphere whose nearer root lies behind, by the same rule, which knows no other
    outside,           ///< a triangle that the line passes: side products of both signs
    edge_on,           ///< a triangle seen exactly edge-on, or without area: all side products are 0
    behind,            ///< the line meets it, at t ≤ 0
    overflow,          ///< a number that decides is not finite: too large for the scalar
    beyond_tolerance,  ///< the tolerance rule refused it
    refused,           ///< the rule or the scalar refused it for reasons of its own
};

/// Whether the ray meets the surface.
constexpr bool is_met(Fate fate) { return fate <= Fate::farther; }

/// A sphere's roots by one rule; none where Δ < 0.
struct RootPair {
    Number discriminant;
    std::optional<Number> t0, t1;
};

struct SphereTest {
    Vec3<double> center;
    double radius = 0;
    RootPair textbook, stable;
};

struct TriangleTest {
    std::array<Vec3<double>, 3> vertices;
    Number a, b, c;         ///< the side products, each named for the vertex opposite to its edge
    Number sum, deficit;    ///< a+b+c and | |a+b+c| − (|a|+|b|+|c|) |
    double tolerance = 10;  ///< of the paper's rule
    bool accepted = false;  ///< what that rule says
    std::optional<std::array<Number, 3>> weights;  ///< a, b and c over their sum: of a triangle that the line meets
};

enum class Kind { sphere, triangle, mesh_face };

/// A step of the tape with its name and what became of it.
struct StoryStep {
    Step step;
    std::string name;
    Checked checked;
};

struct Surface {
    std::size_t number = 0;  ///< among all surfaces
    Kind kind = Kind::sphere;
    Rgb color;
    Fate fate = Fate::refused;
    std::optional<Number> t;    ///< where the line meets it, if it does
    bool needed_exact = false;  ///< error bounds could not tell whether it is met
    std::variant<SphereTest, TriangleTest> test;
    std::vector<StoryStep> steps;  ///< of the test by the rule that was chosen
};

/// One term of the shading: k, what it comes to at this point, and its light.
struct Term {
    double k = 0;
    Number factor;  ///< k_a, I k_d max(0, n·l), I k_s max(0, n·h)^e
    Vec3<double> color;
    Vector product;
    Rgb bytes;  ///< the product cut to whole bytes, as levental-2014 adds them
};

struct Shade {
    ShadingModel model = ShadingModel::blinn_phong;
    double intensity = 1, exponent = 0;
    Vector L, l, r;  ///< towards the light as given and of length 1; towards the viewer
    Number n_l, n_r;
    Vector h;          ///< the half vector; in Phong's own form the reflection 2(n·l)n − l
    Number highlight;  ///< n·h; in Phong's own form r·(2(n·l)n − l)
    Term ambient, diffuse, specular;
    Vector sum;  ///< of the products
};

/// Where the ray first meets a surface, and all that was computed there.
struct FirstHit {
    std::size_t surface = 0;
    Number t;
    bool t_by_exact = false;  ///< t is the truth rounded once, and not what the steps give
    Vector point, normal;
    std::optional<Shade> shade;       ///< from stage 4
    std::vector<StoryStep> steps;     ///< from the surface's test on
    std::size_t tested_before = 0;    ///< so many of them are that test again, as the surface's own steps tell it
    std::optional<StepNumber> worst;  ///< the step that lost the most bits beyond those of its operands
    double worst_loss = 0;            ///< how many
};

}  // namespace story

/// Everything about one pixel.
struct Story {
    std::string title;    ///< the scene's
    std::string command;  ///< what shows this story again; filled in by who knows the command line
    int width = 0, height = 0;
    int x = 0, y = 0;         ///< the pixel; (0, 0) is top left
    int column = 0, row = 0;  ///< the same, from the bottom left
    Options options;
    Rgb color;            ///< the pixel's
    bool border = false;  ///< it is on the border, which is painted over the picture
    Rgb traced;           ///< what the ray brings: differs from `color` on the border only
    Ray<double> ray;
    std::optional<story::Vector> ray_color;   ///< stage 1: the direction as a colour
    std::vector<story::StoryStep> ray_steps;  ///< and how it was computed
    std::size_t tested = 0, met = 0;
    std::vector<story::Surface> surfaces;  ///< those met, and the nearest misses
    std::size_t not_listed = 0;            ///< how many more were missed
    std::optional<story::FirstHit> hit;
};

}  // namespace glassbox
