#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <ray.hpp>
#include <rgb.hpp>
#include <shading.hpp>
#include <vec3.hpp>

#include "explain/replay.hpp"
#include "explain/source_file.hpp"
#include "render/measure/reference_search.hpp"
#include "render/options.hpp"

namespace glassbox {

/// The parts of a pixel's story. All numbers are those that the formulas computed, each with its check.
namespace story {

using Number = Checked;

struct Vector {
    Number x, y, z;
};

/// A surface's result, and the reason.
enum class Fate {
    nearest,           ///< met, and nothing before it
    as_near,           ///< met, exactly as near as the nearest, which is listed later
    farther,           ///< met, behind the nearest
    apart,             ///< a sphere that the line does not touch: Δ < 0
    touched,           ///< a sphere that the line only touches, Δ = 0, by the rule of the paper's program
    from_inside,       ///< a sphere whose nearer root lies behind, by the same rule, which uses no other
    outside,           ///< a triangle that the line passes: side products of both signs
    edge_on,           ///< a triangle seen exactly edge-on, or without area: all side products are 0
    behind,            ///< the line meets it, at t ≤ 0
    overflow,          ///< a deciding number is not finite: too large for the scalar
    beyond_tolerance,  ///< rejected by the tolerance rule
    refused,           ///< rejected by the rule or the scalar for another reason
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
    Number a, b, c;                                ///< the side products, each named after the vertex opposite its edge
    Number sum, deficit;                           ///< a+b+c and | |a+b+c| − (|a|+|b|+|c|) |
    double tolerance = 10;                         ///< of the paper's rule
    bool accepted = false;                         ///< that rule's answer
    std::optional<std::array<Number, 3>> weights;  ///< a, b and c over their sum, for a triangle that the line meets
};

enum class Kind { sphere, triangle, mesh_face };

/// A step of the tape with its name and its check.
struct StoryStep {
    Step step;
    std::string name;
    Checked checked;
};

/// Whether what was computed is what is true.
enum class Mark { right, wrong, unknown };

struct Surface {
    std::size_t number = 0;  ///< among all surfaces
    Kind kind = Kind::sphere;
    Rgb color;
    Fate fate = Fate::refused;
    bool truly_met = false, truly_nearest = false;  ///< by the reference search, if the story has a judgement
    std::optional<Number> t;                        ///< where the line meets the surface, if it does
    bool needed_exact = false;                      ///< error bounds could not decide whether it is met
    std::variant<SphereTest, TriangleTest> test;
    std::vector<StoryStep> steps;  ///< of the test by the chosen rule
    std::vector<Call> calls;       ///< in which they were done
    bool is_finished = true;       ///< otherwise the program ended during the test: there is no answer
};

/// One term of the shading: k, its value at this point, and its light.
struct Term {
    double k = 0;
    Number factor;  ///< k_a, I k_d max(0, n·l), I k_s max(0, n·h)^e
    Vec3<double> color;
    Vector product;
    Rgb bytes;  ///< the product truncated to bytes, as levental-2014 adds them
};

struct Shade {
    ShadingModel model = ShadingModel::blinn_phong;
    double intensity = 1, exponent = 0;
    Vector L, l, r;  ///< towards the light, as given and normalized; towards the viewer
    Number n_l, n_r;
    Vector h;          ///< the half vector; in Phong's original model the reflection 2(n·l)n − l
    Number highlight;  ///< n·h; in Phong's original model r·(2(n·l)n − l)
    Term ambient, diffuse, specular;
    Vector sum;  ///< of the products
};

/// Where the ray first meets a surface, and everything computed there.
struct FirstHit {
    std::size_t surface = 0;
    Number t;
    bool t_by_exact = false;  ///< t is not the steps' result: it was found with more digits, or at another scale
    Vector point, normal;
    std::optional<Shade> shade;       ///< from stage 4
    std::vector<StoryStep> steps;     ///< from the surface's test on
    std::vector<Call> calls;          ///< in which they were done
    std::size_t tested_before = 0;    ///< how many of them repeat that test, as in the surface's own steps
    std::optional<StepNumber> worst;  ///< the step that lost the most bits of its own
    double worst_loss = 0;            ///< how many bits
};

/// The least sure of the signs that decide what a pixel shows. For a hit: whether its surface is met, and for each
/// other surface whether it is missed or lies farther; for a miss, whether each surface is missed.
struct LeastSure {
    double sureness = 0;  ///< |s| over its guaranteed bound: above 1 the sign is the true one; infinite if s is exact
    std::size_t surface = 0;
    std::optional<std::size_t>
        nearer_than;                  ///< the sign is that of a difference: t of this surface, less that of `surface`
    std::optional<std::size_t> row;   ///< of `surface` in Story::surfaces
    std::optional<StepNumber> step;   ///< of that row's steps: the number whose sign it is
    std::string name;                 ///< what the formula calls the number: "c", "Δ"
    std::optional<StepNumber> worst;  ///< of the steps that lead to it, the one that lost the most bits itself
    double worst_loss = 0;            ///< how many bits
};

/// How a program that records a story ended before it was done.
struct EarlyEnd {
    std::string words;    ///< "it followed a null pointer (address 0x0)"
    bool at_hit = false;  ///< all tests were done
    Call in;              ///< the call that it was in; of none, there is no name
};

/// What a pixel shows, beside the truth: the reference search's, which shares nothing with the search that is judged.
/// Both are about the doubles of the scene and the ray; colours are not judged.
struct Judgement {
    Verdict verdict = Verdict::right;
    std::optional<std::size_t> shown,
        truth;                        ///< the nearest surface: as it was found, and truly; none if nothing is met
    bool shown_is_there = false;      ///< the ray truly meets the surface that is shown
    bool at_once = false;             ///< both surfaces are truly met at the same t
    bool truth_needed_exact = false;  ///< bounds alone do not prove the truth; exact arithmetic does
    std::size_t wrongly_met = 0, wrongly_missed = 0;  ///< of all surfaces
    bool by_rule = false;  ///< the verdict is wrong, and the rule, computed without any rounding, says the same
    std::vector<std::string>
        turned;               ///< the numbers of the wrongly judged surface that rounding put on another side of 0
    bool is_weighed = false;  ///< the least sure sign was looked for
    std::optional<LeastSure> least;  ///< none where there is no surface
};

}  // namespace story

/// Everything about one pixel.
struct Story {
    std::string title;    ///< the scene's
    std::string command;  ///< the command that shows this story again; filled in by the command line's code
    int width = 0, height = 0;
    int x = 0, y = 0;         ///< the pixel; (0, 0) is top left
    int column = 0, row = 0;  ///< the same, from the bottom left
    Options options;
    Rgb color;            ///< the pixel's
    bool border = false;  ///< it is on the border, which is painted over the picture
    Rgb traced;           ///< the ray's colour: differs from `color` only on the border
    Ray<double> ray;
    std::optional<story::Vector> ray_color;          ///< stage 1: the direction as a colour
    std::vector<story::StoryStep> ray_steps;         ///< its computation
    std::vector<Call> ray_calls;                     ///< in which it was done
    std::size_t in_all = 0;                          ///< surfaces
    std::size_t tested = 0;                          ///< of these, on the way to what the ray meets first
    std::optional<std::size_t> nodes, boxes_missed;  ///< of the engine's hierarchy: visited; their boxes, missed
    std::size_t met = 0;
    std::optional<story::Judgement> judgement;  ///< none in stage 1, and for a ray that is not valid
    std::vector<story::Surface> surfaces;       ///< those met, and the nearest misses
    std::size_t not_listed = 0;                 ///< how many more were missed
    std::optional<story::FirstHit> hit;
    std::shared_ptr<const OwnSources> own;  ///< whose formulas these are, if not ours; else null
    std::optional<story::EarlyEnd> ended;   ///< of formulas that are not ours: they did not get to the end
};

}  // namespace glassbox
