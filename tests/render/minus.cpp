// A measurement minus the same by other settings: values that can be worked out by hand, and what has none.
#include "render/measure/measure_difference.hpp"

#include <doctest.h>

#include <cmath>
#include <limits>

#include "render/typed.hpp"
#include "scene/error.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Scene paper = read_scene(SCENES "/levental-2014.toml");

/// A sphere of radius 50, ten millions away from the start of the paper's rays; the ray of column 350 and row 350, the
/// pixel (350, 149), runs through its centre.
Scene far_sphere() {
    Scene scene = paper;
    scene.triangles.clear();
    scene.spheres = {{{-9999500, 350, 350}, 50, {0, 255, 0}}};
    return scene;
}

Setup by(Scalar scalar, const SphereRule& rule = Textbook{}) {
    Setup setup = setup_of(paper);
    setup.options.scalar = scalar;
    setup.options.sphere_rule = rule;
    return setup;
}

std::vector<MeasuredDifference> difference(const Scene& scene, const Setup& setup, const char* settings,
                                           const char* what) {
    const Measurement* const wanted = find_measurement(what);
    REQUIRE(wanted != nullptr);
    return measure_difference(scene, setup, minus("--minus", settings), {&wanted, 1});
}

}  // namespace

// From P = (500, 350, 350) with v = P − C = (10⁷, 0, 0) the sphere is met at t = 10⁷ − 50. By the textbook in float,
// c = v² − r² = 10¹⁴ − 2500 is rounded to a multiple of 2²³, as v² is, so Δ = b² − ac = 0 and t = −b/a = 10⁷. A ray 60
// beside it misses the sphere, but by the same rounding float meets it.
TEST_CASE("float depth minus certified depth of a far sphere is 50; without a hit on either side there is none") {
    const auto found = difference(far_sphere(), by(Scalar::float_), "scalar:certified", "depth");
    REQUIRE(found.size() == 1);
    const MeasuredDifference& depth = found.front();
    CHECK(depth.one.at({350, 149}) == 1e7);
    CHECK(depth.other.at({350, 149}) == 9999950);
    CHECK(depth.channel.at({350, 149}) == 50);
    CHECK(depth.one.at({410, 149}) == 1e7);
    CHECK(std::isnan(depth.other.at({410, 149})));
    CHECK(std::isnan(depth.channel.at({410, 149})));
    CHECK(depth.what->name == "depth-minus-scalar:certified");
    CHECK(depth.channel.name == "depth-minus-scalar:certified");
    CHECK(depth.what->unit == "|D|");
    CHECK(depth.what->explanation ==
          "depth with scalar float minus depth with scalar certified; depth: t of the nearest surface, in lengths of "
          "the ray's direction");

    // The other way round it has the other sign; double is exact here, as 10¹⁴ is below 2⁵³.
    const auto back = difference(far_sphere(), by(Scalar::certified), "scalar:float", "depth");
    CHECK(back.front().channel.at({350, 149}) == -50);
    CHECK(difference(far_sphere(), by(Scalar::double_), "scalar:exact", "depth").front().channel.at({350, 149}) == 0);
}

TEST_CASE("what is infinite on both sides does not differ; one infinity is left as it is") {
    // In the tetrahedron's outline the deciding triangle's side products have one sign: the paper's difference is 0, by
    // small whole numbers in any scalar, and its logarithm −∞.
    const Pixel inside{370, 499 - 110};
    const auto deficit = difference(paper, by(Scalar::float_), "scalar:double", "deficit");
    CHECK(deficit.front().one.at(inside) == -infinity);
    CHECK(deficit.front().other.at(inside) == -infinity);
    CHECK(deficit.front().channel.at(inside) == 0);
}

TEST_CASE("of a normal each component has a difference of its own") {
    const auto normal = difference(paper, by(Scalar::float_), "scalar:certified", "normal");
    REQUIRE(normal.size() == 3);
    CHECK(normal[1].what->name == "normal.y-minus-scalar:certified");
    // At the green sphere's middle it is (1, 0, 0) by both.
    for (const MeasuredDifference& component : normal) CHECK(component.channel.at({350, 149}) == 0);
}

// The tangent ray of column 300 and row 350 meets the green sphere, of radius 50 about (100, 350, 350), once; the
// paper's program takes that for a miss.
TEST_CASE("a rule is a setting, too; several are changed at once") {
    const Setup as_published = by(Scalar::certified, Levental2014{});
    const auto hits = difference(paper, as_published, "sphere:stable", "hits");
    CHECK(hits.front().channel.at({300, 149}) == -1);
    CHECK(hits.front().channel.at({350, 149}) == 0);
    const auto both = difference(paper, as_published, "scalar:double,sphere:stable", "hits");
    CHECK(both.front().what->name == "hits-minus-scalar:double+sphere:stable");
    CHECK(both.front().channel.at({300, 149}) == -1);
}

TEST_CASE("shading and light are settings: half the intensity is half the diffuse light") {
    Setup setup = by(Scalar::certified);
    setup.light_intensity = 1;
    const auto diffuse = difference(paper, setup, "intensity:0.5", "diffuse");
    // I k_d n·l with k_d = 1 and n·l = 4/√18 at the green sphere's middle; halves of doubles are exact.
    CHECK(diffuse.front().channel.at({350, 149}) == diffuse.front().one.at({350, 149}) / 2);
    CHECK(diffuse.front().one.at({350, 149}) == doctest::Approx(4 / std::sqrt(18.0)));
}

TEST_CASE("where no pixel has a value the reason is that of the side that has none") {
    const auto why = [](const Setup& setup, const char* settings, const char* what) {
        return difference(far_sphere(), setup, settings, what).front().channel.why_no_value;
    };
    CHECK(why(by(Scalar::float_), "scalar:certified", "undecided") == "float proves nothing; certified and exact do");
    CHECK(why(by(Scalar::certified), "scalar:float", "undecided") == "float proves nothing; certified and exact do");
    CHECK(why(by(Scalar::certified), "stage:1", "depth") == "from stage 2");
    CHECK(why(by(Scalar::float_), "scalar:certified", "depth").empty());
}

TEST_CASE("settings are read and written; what is none is refused") {
    CHECK(written(minus("--minus", "scalar:certified")) == "scalar:certified");
    CHECK(written(minus("--minus", "triangle:tolerance:0.5,scalar:exact")) == "scalar:exact,triangle:tolerance:0.5");
    CHECK(written(minus("--minus", "turn:z:10,y:-20,scalar:float")) == "turn:z:10,y:-20,scalar:float");
    CHECK(written(minus("--minus", "light:1,2,3,accumulated:on")) == "accumulated:on,light:1,2,3");
    CHECK(difference_name("depth", minus("--minus", "light:1,2,3")) == "depth-minus-light:1+2+3");
    CHECK(difference_file_name("n.l", minus("--minus", "scalar:exact")) == "n.l-minus-scalar-exact");
    CHECK(changed_by(minus("--minus", "scalar:exact"), by(Scalar::float_)) == by(Scalar::exact));

    const auto complaint = [](const char* settings) -> std::string {
        try {
            minus("--minus", settings);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(complaint("certified") ==
          "--minus: 'certified' must be NAME:VALUE, an option and its value, such as scalar:certified");
    CHECK(complaint("") == "--minus: '' must be NAME:VALUE, an option and its value, such as scalar:certified");
    CHECK(complaint("scaler:exact") == "--minus: 'scaler' is no option; did you mean 'scalar'?");
    CHECK(complaint("scalar:exakt") == "--minus scalar: 'exakt' is not known; did you mean 'exact'?");
    CHECK(complaint("scalar:exact,scalar:float") == "--minus: 'scalar' is there twice; name it once");
}

TEST_CASE("words have no difference") {
    CHECK(why_no_difference(*find_measurement("verdict")) ==
          "verdict is told in words (right, wrong hit, wrong miss, wrong surface), and words have no difference");
    CHECK(why_no_difference(*find_measurement("depth")).empty());
}
