// What a pixel's story says of the truth: known verdicts, the measurement's verdicts, and proofs that are never wrong.
#include <doctest.h>

#include <cmath>
#include <utility>

#include "explain/explain.hpp"
#include "explain/phrases.hpp"
#include "explain/verdict_phrases.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;
using namespace glassbox::story;

namespace {

Scene read(const std::string& name) { return read_scene(SCENES "/" + name + ".toml"); }

Options with(Scalar scalar, const TriangleRule& triangle = Pluecker{}, const SphereRule& sphere = Stable{}) {
    Options options;
    options.scalar = scalar;
    options.triangle_rule = triangle;
    options.sphere_rule = sphere;
    return options;
}

std::string line(const std::string& scene, int x, int y, const Options& options = {}) {
    return verdict_line(explain(read(scene), options, x, y));
}

double measured(const Scene& scene, const Options& options, const char* what, int x, int y) {
    const Measurement* const one = find_measurement(what);
    return measure(scene, options, std::span(&one, 1), {}).at(0).at(0).at({x, y});
}

}  // namespace

// By the rule of 10 every ray of the picture hits the triangle of size 1 (tests/render/failing_scenes.cpp); pixel
// (399, 0) looks at (2.49, 2.49), far outside.
TEST_CASE("the tolerance hits where nothing is, and does so without any rounding") {
    for (const Scalar scalar : {Scalar::certified, Scalar::double_, Scalar::float_})
        CHECK(line("tolerance-tiny", 399, 0, with(scalar, Tolerance{})) ==
              "wrong hit, proven by error bounds: surface 0 is shown, and nothing is there; so says the rule "
              "tolerance:10, "
              "without any rounding");
    CHECK(line("tolerance-tiny", 399, 0).starts_with("right, proven, "));
}

// Pixel (400, 149) touches the green sphere: the paper's program misses it. In inside.toml it sees no far roots.
TEST_CASE("the paper's sphere rule misses what is only touched, and what is seen from inside") {
    const Options history = with(Scalar::certified, Pluecker{}, Levental2014{});
    CHECK(line("levental-2014", 400, 149, history) ==
          "wrong miss, proven in exact arithmetic: nothing is shown, and surface 0 is there; so says the rule "
          "levental-2014, without any rounding");
    CHECK(line("inside", 20, 20, history)
              .starts_with("wrong miss, proven by error bounds: nothing is shown, and surface "));
    CHECK(line("levental-2014", 350, 149, history).starts_with("right, proven, "));
}

// 4000 off, floats near v² are 1 apart, and Δ comes out as 0 or more up to 0.7 from the sphere's middle (0.45, −0.15).
// Pixel (360, 119) looks at (0.30125, 0.00125), 0.21 from there, where the sphere of radius 0.1 is not.
TEST_CASE("in float the textbook's far sphere is hit where it is not: rounding turned the sign of Δ") {
    const Story story = explain(read("spheres-far"), with(Scalar::float_, Pluecker{}, Textbook{}), 360, 119);
    REQUIRE(story.judgement);
    CHECK(story.judgement->verdict == Verdict::wrong_hit);
    CHECK_FALSE(story.judgement->shown_is_there);
    CHECK_FALSE(story.judgement->by_rule);
    CHECK(story.judgement->turned == std::vector<std::string>{"Δ"});
    CHECK(verdict_line(story).ends_with("is shown, and nothing is there; rounding turned the sign of Δ"));
    CHECK(line("spheres-far", 360, 119).starts_with("right, proven, "));
}

TEST_CASE("what is not traced, not valid, or painted over is called so") {
    Options first;
    first.stage = 1;
    const Story rays = explain(read("levental-2014"), first, 350, 149);
    CHECK(mark_of(rays) == Mark::unknown);
    CHECK(verdict_line(rays) == "stage 1 traces nothing: the colour is the ray's direction");
    CHECK(
        line("levental-2014", 0, 7).starts_with("border, painted over what the ray brings; beneath it: right, proven"));
    Scene empty = read("levental-2014");
    empty.spheres.clear();
    empty.triangles.clear();
    CHECK(verdict_line(explain(empty, {}, 350, 149)) == "right, proven: there is no surface");
}

// Surfaces 8 and 9 of edges.toml share an edge that pixel (120, 8) looks at, a hair off: no double tells the two apart.
TEST_CASE("what bounds leave open is proven in exact arithmetic, and the words say whose number it is") {
    const Story story = explain(read("edges"), {}, 120, 8);
    REQUIRE(story.judgement);
    REQUIRE(story.judgement->least);
    CHECK(story.judgement->least->sureness <= 1);
    CHECK(verdict_line(story).starts_with("right, proven in exact arithmetic: surface "));
    CHECK(verdict_line(story).find("; error bounds alone leave open the sign of ") != std::string::npos);
    CHECK(margin_in_words(*story.judgement->least, story.options)
              .ends_with(" digits by bounds alone, decided in exact arithmetic"));
    CHECK(story.judgement->least->step.has_value());
    CHECK(lost_by(*story.judgement->least, story).find(" lost ") != std::string::npos);
}

#ifdef GLASSBOX_SANITIZED
constexpr int stride = 23;  // checked code is slow
#else
constexpr int stride = 1;
#endif

// The certified search and the reference share nothing; and what running bounds prove can only be right.
TEST_CASE("the verdict is the measurement's, the truth is what certified finds, and no proof is wrong") {
    struct {
        const char* scene;
        int width, height;
        Options options;
    } all[] = {
        {"mesh-far", 18, 12, with(Scalar::float_)},
        {"mesh-far", 18, 12, with(Scalar::double_)},
        {"mesh-far", 18, 12, with(Scalar::certified)},
        {"edges", 16, 8, with(Scalar::double_, MoellerTrumbore{})},
        {"edges", 16, 8, with(Scalar::float_)},
        {"spheres-far", 24, 12, with(Scalar::float_, Pluecker{}, Textbook{})},
        {"spheres-far", 24, 12, with(Scalar::long_double)},
        {"levental-2014", 25, 25, with(Scalar::double_, Tolerance{}, Levental2014{})},
        {"inside", 12, 12, with(Scalar::double_, Pluecker{}, Textbook{})},
    };
    int proven = 0, open = 0, wrong = 0;
    for (const auto& each : all) {
        CAPTURE(each.scene);
        const Options& options = each.options;
        const int width = each.width, height = each.height;
        const Scene scene = resized(read(each.scene), width, height);
        const Measurement* const what = find_measurement("verdict");
        const Channel verdicts = measure(scene, options, std::span(&what, 1), {}).at(0).at(0);
        Job job;
        job.engine = build_engine(scene, options.stage, 1);
        for (int y = 0; y < height; ++y)
            for (int x = y % stride; x < width; x += stride) {
                const Story story = explain(scene, options, x, y, Detail::whole, job);
                REQUIRE(story.judgement);
                const Judgement& judgement = *story.judgement;
                CHECK(static_cast<double>(judgement.verdict) == verdicts.at({x, y}));
                const Story certified = explain(scene, with(Scalar::certified), x, y, Detail::recorded, job);
                const auto found = certified.hit ? std::optional(certified.hit->surface) : std::nullopt;
                CHECK(judgement.truth == found);
                REQUIRE(judgement.least);
                const LeastSure& least = *judgement.least;
                const bool sure = least.sureness > 1;
                if (sure && is_geometry(options.triangle_rule) && is_geometry(options.sphere_rule))
                    CHECK(judgement.verdict == Verdict::right);
                const bool says_proven = verdict_line(story).find("right, proven") != std::string::npos;
                CHECK(says_proven == (judgement.verdict == Verdict::right && (sure || is_proven(options.scalar))));
                ++(judgement.verdict != Verdict::right ? wrong : sure ? proven : open);
                if (!least.step || least.nearer_than || options.triangle_rule != TriangleRule(Pluecker{})) continue;
                // The sign that is named is as sure as the number beside its bound.
                const Checked& number = story.surfaces[*least.row].steps[*least.step].checked;
                CAPTURE(least.name);
                if (options.scalar != Scalar::long_double && number.error > 0 && least.sureness > 0)
                    CHECK(std::abs(number.value) / number.error == doctest::Approx(least.sureness).epsilon(1e-6));
            }
    }
    CHECK(proven > 100 / stride);
    CHECK(open > 100 / stride);
    CHECK(wrong > 100 / stride);
}

// Two spheres, one 1e-9 behind the other: the difference of their t₀, near 350, decides.
TEST_CASE("which of two is nearer is a sign, too, and a sphere's t is its root") {
    Scene scene = read("levental-2014");
    scene.triangles.clear();
    scene.spheres = {{{100, 350, 350}, 50, {0, 255, 0}}, {{100 - 1e-9, 350, 350}, 50, {255, 0, 0}}};
    const Story story = explain(scene, {}, 350, 149);
    REQUIRE(story.judgement);
    REQUIRE(story.judgement->least);
    const LeastSure& least = *story.judgement->least;
    CHECK(story.judgement->shown == 0);
    CHECK(least.surface == 1);
    CHECK(least.nearer_than == 0);
    REQUIRE(least.step);
    CHECK(story.surfaces.at(1).steps.at(*least.step).name == "t₀");
    CHECK(whose(least) == "t of surfaces 0 and 1");
    // They are 1e-9 apart, and each t, near 350, has an error of some u·350 = 4e-14: at most five digits are to spare.
    CHECK(margin(least) < 5);
}

TEST_CASE("a margin is rounded down, so that as many digits are there") {
    LeastSure least;
    least.sureness = 1000;  // log10 is 3, and rounding may have made it less
    CHECK(margin(least) == 2.9);
    least.sureness = 1001;
    CHECK(margin_text(least) == "3.0");
    least.sureness = 1e14 * 1.9;  // 10^14.2 is 1.58e14, 10^14.3 is 2.0e14
    CHECK(margin_text(least) == "14.2");
    least.sureness = 0;
    CHECK(margin_text(least) == "−∞");
    least.sureness = .2;  // 10^−0.7 is 0.1995, 10^−0.6 is 0.25
    CHECK(margin_text(least) == "−0.7");
    least.sureness = INFINITY;
    CHECK(margin_text(least) == "∞");
    CHECK(margin_in_words(least, with(Scalar::double_)) == "∞ digits to spare");
    least.sureness = .2;
    CHECK(margin_in_words(least, with(Scalar::double_)) == "−0.7 digits, undecided");
    CHECK(margin_in_words(least, with(Scalar::certified)) ==
          "−0.7 digits by bounds alone, decided in exact arithmetic");
}

TEST_CASE("where the line names several numbers, the least margin's is said to be one of them") {
    Story story;
    story.judgement = Judgement{};
    Judgement& judgement = *story.judgement;
    judgement.verdict = Verdict::wrong_hit;
    judgement.shown = 55;
    judgement.turned = {"b", "c"};
    LeastSure least;
    least.surface = 55;
    least.name = "c";
    CHECK(whose(least, story) == "c of surface 55, the least sure of b and c");
    // A miss needs only one sign that is sure: the least margin is that of the surest of several.
    judgement.verdict = Verdict::wrong_miss;
    judgement.truth = std::exchange(judgement.shown, std::nullopt);
    CHECK(whose(least, story) == "c of surface 55, one of b and c");
    judgement.turned = {"c"};
    CHECK(whose(least, story) == "c of surface 55");
    judgement.turned = {"a", "b"};
    CHECK(whose(least, story) == "c of surface 55");
    least.surface = 7;
    judgement.turned = {"b", "c"};
    CHECK(whose(least, story) == "c of surface 7");
}

TEST_CASE("two numbers that cancel are shown with as many digits as they differ in") {
    const auto shown = [](double left, Operation operation, double right) {
        std::vector<StoryStep> steps(3);
        steps[0].checked = unchecked(left);
        steps[1].checked = unchecked(right);
        steps[2].step.operation = operation;
        steps[2].step.left = 0;
        steps[2].step.right = 1;
        return glassbox::operation(steps, steps[2].step);
    };
    CHECK(shown(1000000.25, Operation::subtract, 1000000) == "1000000.2 − 1000000");
    CHECK(shown(254160179.25, Operation::add, -254160178.5) == "254160179 + −254160178");
    CHECK(shown(2, Operation::add, -2) == "2 + −2");
    CHECK(shown(1 / 3.0, Operation::multiply, 1 / 3.0) == "0.333333 × 0.333333");
    CHECK(shown(100.00000001, Operation::greater, 100) == "100.00000001 > 100");
}

TEST_CASE("tests, nodes and boxes are those that the measurements count") {
    const Scene room = read("room");
    Options fast;
    fast.engine = EngineChoice::fast;
    for (const auto& [x, y] : {std::pair(330, 200), {10, 10}, {200, 120}}) {
        const Story plain = explain(room, {}, x, y), quick = explain(room, fast, x, y);
        CHECK(plain.tested == 1255);
        CHECK(plain.in_all == 1255);
        CHECK_FALSE(plain.nodes);
        CHECK(quick.in_all == 1255);
        CHECK(static_cast<double>(quick.tested) == measured(room, fast, "tests", x, y));
        REQUIRE(quick.nodes);
        CHECK(static_cast<double>(*quick.nodes) == measured(room, fast, "nodes", x, y));
        CHECK(static_cast<double>(*quick.boxes_missed) == measured(room, fast, "boxes-missed", x, y));
        CHECK(quick.met == plain.met);
    }
}

TEST_CASE("the true surface is listed, though it is missed, and so is the least sure one") {
    const Story story = explain(read("levental-2014"), with(Scalar::certified, Pluecker{}, Levental2014{}), 400, 149);
    REQUIRE(story.surfaces.at(0).number == 0);
    CHECK(story.surfaces[0].truly_nearest);
    CHECK(mark_of(story.surfaces[0], story) == Mark::wrong);
    CHECK(truth_of(story.surfaces[0], story) == "wrong: truly met, nearest");
    CHECK(truth_of(story.surfaces[1], story) == "right: truly missed");
}
