// Why a measurement has no value: every measurement, at every stage, in every scalar, by every rule, on scenes that
// lack one thing each.
#include "render/measure/why_no_value.hpp"

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "render/option_names.hpp"
#include "render/render.hpp"

using namespace glassbox;

namespace {

enum class Has { spheres, triangles, nothing, only_missed };

/// Four rays along −x, from (10, 0, 0), (10, 1, 0), (10, 0, 1) and (10, 1, 1), meet all that there is but what is
/// missed: that lies a thousand to the side.
Scene scene_with(Has what) {
    Scene scene;
    scene.width = scene.height = 2;
    scene.view = ParallelView{{10, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};
    const double y = what == Has::only_missed ? 1000 : 0;
    if (what == Has::spheres || what == Has::only_missed) scene.spheres = {{{0, y, 0}, 5, {1, 2, 3}}};
    if (what == Has::triangles || what == Has::only_missed)
        scene.triangles = {{{Vec3<double>{0, y - 50, -50}, {0, y + 100, -50}, {0, y - 50, 100}}, {1, 2, 3}}};
    return scene;
}

using Reasons = std::map<std::string_view, std::string>;

/// What is said of each of these measurements, made at once.
Reasons said(const Scene& scene, const Options& options, const std::vector<const Measurement*>& wanted) {
    Reasons reasons;
    const auto all = measure(scene, options, wanted);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        for (const Channel& plane : all[i]) {
            const bool any = std::ranges::any_of(plane.values, [](double value) { return !std::isnan(value); });
            CHECK(any == plane.why_no_value.empty());
        }
        reasons[wanted[i]->name] = all[i].front().why_no_value;
    }
    return reasons;
}

std::string said(const Scene& scene, const Options& options, const char* what) {
    return said(scene, options, {find_measurement(what)}).at(what);
}

/// The reasons of all measurements: those of boxes are requested separately, because they choose the engine, which the
/// others then use, too.
Reasons all_said(const Scene& scene, const Options& options) {
    std::vector<const Measurement*> of_boxes, others;
    for (const Measurement& each : measurements()) (each.needs.boxes ? of_boxes : others).push_back(&each);
    Reasons reasons = said(scene, options, others);
    reasons.merge(said(scene, options, of_boxes));
    return reasons;
}

/// What docs/measurements.md says of it.
std::string expected(std::string_view what, Has has, const Options& options, ShadingModel model) {
    const auto is = [&](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, what) != names.end();
    };
    const bool missed = has == Has::only_missed;
    const bool spheres = (has == Has::spheres || missed) && options.stage >= 2;
    const bool triangles = (has == Has::triangles || missed) && options.stage >= 3;
    const bool met = !missed && (spheres || triangles);
    const bool certified = options.scalar == Scalar::certified, exact = options.scalar == Scalar::exact;
    if (is({"tests", "hits", "verdict", "drift"})) return "";
    if (what == "undecided")
        return certified || exact ? ""
                                  : std::string(name_of(options.scalar)) + " proves nothing; certified and exact do";
    const int stage = is({"n.l", "n.h", "n.r", "ambient", "diffuse", "specular"}) ? 4
                      : is({"side", "margin", "deficit", "identity"})             ? 3
                                                                                  : 2;
    if (options.stage < stage) return "from stage " + std::to_string(stage);
    if (is({"nodes", "boxes-missed"})) {
        if (options.engine == EngineChoice::plain) return "the plain loop has no boxes";
        if (std::holds_alternative<Tolerance>(options.triangle_rule))
            return "boxes are the fast engine's, and tolerance hits triangles where they are not";
        if (!certified) return "boxes are the fast engine's, and that answers certified";
        return spheres || triangles ? "" : "no surface was tested";
    }
    if (what == "discriminant") return spheres ? "" : "no sphere was tested";
    if (stage == 3) {
        if (std::holds_alternative<MoellerTrumbore>(options.triangle_rule))
            return "moeller-trumbore has no side products";
        return triangles ? "" : "no triangle was tested";
    }
    if (what == "n.h" && model == ShadingModel::phong) return "phong has no half vector";
    return met ? "" : "no ray meets a surface";
}

}  // namespace

TEST_CASE("every measurement × scalar × rule × stage × engine: a value, or the reason") {
    int reasons = 0;
    for (const Has has : {Has::spheres, Has::triangles, Has::nothing, Has::only_missed})
        for (const ShadingModel model : {ShadingModel::blinn_phong, ShadingModel::phong}) {
            Scene scene = scene_with(has);
            scene.shading.model = model;
            for (const Named<Scalar>& scalar : scalars)
                for (const TriangleRule& triangle :
                     {TriangleRule(Pluecker{}), TriangleRule(Tolerance{}), TriangleRule(MoellerTrumbore{})})
                    for (const SphereRule& sphere : {SphereRule(Stable{}), SphereRule(Textbook{})})
                        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::plain})
                            for (int stage = 1; stage <= 5; ++stage) {
                                Options options;
                                options.stage = stage;
                                options.scalar = scalar.value;
                                options.engine = engine;
                                options.triangle_rule = triangle;
                                options.sphere_rule = sphere;
                                CAPTURE(scalar.name);
                                CAPTURE(stage);
                                for (const auto& each : all_said(scene, options)) {
                                    CAPTURE(each.first);
                                    REQUIRE(each.second == expected(each.first, has, options, model));
                                    reasons += !each.second.empty();
                                }
                            }
        }
    CHECK(reasons > 10'000);
}

// The three examples of a wrong reason that were found.
TEST_CASE("a sphere has no margin; double does not know what is undecided; Möller and Trumbore have no side products") {
    const Scene sphere = scene_with(Has::spheres);
    Options options;
    CHECK(said(sphere, options, "margin") == "no triangle was tested");
    options.scalar = Scalar::double_;
    CHECK(said(sphere, options, "undecided") == "double proves nothing; certified and exact do");
    options = {};
    options.triangle_rule = MoellerTrumbore{};
    CHECK(said(scene_with(Has::triangles), options, "margin") == "moeller-trumbore has no side products");
}

// Products of coordinates of 1e30 are no floats.
TEST_CASE("too large for the scalar") {
    Options options;
    options.scalar = Scalar::float_;
    Scene scene;
    scene.width = scene.height = 2;
    scene.view = ParallelView{{1e30, 2e29, 2e29}, {0, 1e29, 0}, {0, 0, 1e29}, {-1, 0, 0}};
    scene.spheres = {{{0, 0, 0}, 1e30, {1, 2, 3}}};
    scene.triangles = {{{Vec3<double>{0, -5e30, -5e30}, {0, 1e31, -5e30}, {0, -5e30, 1e31}}, {1, 2, 3}}};
    const std::string too_large = "not a number: too large or too small for float";
    for (const char* what : {"discriminant", "side", "deficit", "identity"}) {
        CAPTURE(what);
        CHECK(said(scene, options, what) == too_large);
    }
    CHECK(said(scene, options, "margin").empty());  // it says of all that they are not decided
    options.scalar = Scalar::double_;
    for (const char* what : {"discriminant", "side", "deficit", "identity"}) CHECK(said(scene, options, what).empty());
}

// Side products of a triangle of size 1/100 are under 10 at all of these pixels, 0.1 to 1 beside it.
TEST_CASE("a wrong hit has no bits to lose") {
    Scene scene = scene_with(Has::nothing);
    scene.triangles = {{{Vec3<double>{0, 0.3, 0.3}, {0, 0.31, 0.3}, {0, 0.3, 0.31}}, {1, 2, 3}}};
    Options options;
    options.triangle_rule = Tolerance{};
    CHECK(said(scene, options, "bits-lost") == "no ray meets the surface that it should");
    CHECK(said(scene, options, "depth").empty());
    options.triangle_rule = Pluecker{};
    CHECK(said(scene, options, "bits-lost") == "no ray meets a surface");
}

TEST_CASE("rays that are none, rays that no boxes are for, and surfaces that boxes leave out") {
    Scene scene = scene_with(Has::spheres);
    std::get<ParallelView>(scene.view).direction = {0, 0, 0};
    for (const char* what : {"depth", "n.l", "verdict", "bits-lost", "nodes"}) {
        CAPTURE(what);
        CHECK(said(scene, {}, what) == "no ray has a direction and finite numbers");
    }
    CHECK(said(scene, {}, "tests").empty());

    scene = scene_with(Has::spheres);
    std::get<ParallelView>(scene.view).corner = {1e200, 0, 0};
    CHECK(said(scene, {}, "nodes") ==
          "the numbers are too large or too small for boxes: every ray took the plain loop");

    scene = scene_with(Has::only_missed);
    Options fast;
    fast.engine = EngineChoice::fast;
    CHECK(said(scene, fast, "discriminant") == "no sphere was tested");
    CHECK(said(scene, fast, "margin") == "no triangle was tested");
    CHECK(said(scene, fast, "nodes").empty());
}
