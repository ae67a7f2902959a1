// Nudged inputs: which signs and verdicts flip, against cases at an edge.
#include "explain/nudge.hpp"

#include <doctest.h>

#include <algorithm>

#include "far_sphere.hpp"

using namespace glassbox;

namespace {

/// The paper's view of one triangle in the plane x = 0. The ray of column 350 and row 350 starts at (500, 350, 350),
/// runs along (−1, 0, 0), and meets it in its vertex A: a hit, with b = c = 0.
Story at_a_vertex(Scalar scalar) {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.spheres.clear();
    scene.triangles = {{{{{0, 350, 350}, {0, 450, 350}, {0, 350, 450}}}, {255, 255, 255}}};
    Options options;
    options.scalar = scalar;
    return explain(scene, options, 350, 149);
}

std::ptrdiff_t flips(const Nudged& nudged) {
    return std::ranges::count_if(nudged.answers, [](const NudgedAnswer& answer) { return answer.flips(); });
}

const NudgedInput& input_of(const Nudged& nudged, const std::string& name) {
    return *std::ranges::find(nudged.inputs, name, &NudgedInput::name);
}

}  // namespace

TEST_CASE("a number further down, the ray passes the vertex: one sign flips, and with it the verdict") {
    for (const Scalar scalar : {Scalar::certified, Scalar::double_, Scalar::float_}) {
        const Story story = at_a_vertex(scalar);
        const std::vector<Nudge> nudges{{"P.y", -1}};
        const Nudged nudged = glassbox::nudged(story, 0, nudges);
        CHECK(nudged.before == NudgedVerdict{true, true});
        CHECK(nudged.after == NudgedVerdict{false, false});
        CHECK(flips(nudged) == 1);  // b's: 0 is both ≥ 0 and ≤ 0
        const auto flipped = std::ranges::find_if(nudged.answers, &NudgedAnswer::flips);
        CHECK(flipped->condition.starts_with("b "));
        CHECK(flipped->before->number.value == 0);
        CHECK(flipped->before->holds);
        CHECK(flipped->after->number.value != 0);
        CHECK(flipped->after->truly == false);
        // From 256 to 512 doubles are 2^-44 apart, floats 2^-15.
        CHECK(input_of(nudged, "P.y").after == 350 - (scalar == Scalar::float_ ? 0x1p-15 : 0x1p-44));
        CHECK(input_of(nudged, "P.y").by == -1);
        CHECK(input_of(nudged, "P.z").after == 350);
    }
}

TEST_CASE("a number further up, the ray meets the edge AB; nudges of an input add up; unknown ones are none") {
    const Story story = at_a_vertex(Scalar::double_);
    const std::vector<Nudge> up{{"P.y", 1}}, down_and_up{{"P.y", -3}, {"P.y", 3}}, unknown{{"radius", 5}},
        vertex{{"A.z", 1}};
    CHECK(nudged(story, 0, up).after == NudgedVerdict{true, true});
    CHECK(flips(nudged(story, 0, up)) == 1);  // b has a sign now
    const Nudged back = nudged(story, 0, down_and_up);
    CHECK(input_of(back, "P.y").after == 350);
    CHECK(flips(back) == 0);
    CHECK(back.after == back.before);
    CHECK(flips(nudged(story, 0, unknown)) == 0);
    CHECK(nudged(story, 0, vertex).after.met == false);  // A moves up, away from the ray
    CHECK(nudged(story, 0, {}).inputs.size() == 15);     // P, D, A, B and C
}

// In float the far sphere's Δ is 0 where it is truly −1100 (far_sphere.hpp has the numbers): met, and truly missed.
TEST_CASE("a nudged test says what is true, too") {
    const Story story = story_of_far_sphere(410);
    const std::vector<Nudge> nudges{{"radius", 1}};
    const Nudged nudged = glassbox::nudged(story, 0, nudges);
    CHECK(nudged.before == NudgedVerdict{true, false});
    CHECK(in_words(nudged.before) == "met, and truly missed");
    REQUIRE(!nudged.answers.empty());
    CHECK(nudged.answers[0].condition == "Δ ≥ 0");
    CHECK(nudged.answers[0].before->holds);
    CHECK(nudged.answers[0].before->truly == false);
    CHECK(input_of(nudged, "radius").after == 50 + 0x1p-18);  // floats from 32 to 64 are 2^-18 apart
}
