// The command that shows a pixel again tells the same story: it is run with the built program.
#include "viewer/model/state/command.hpp"

#include <doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.hpp"
#include "explain/explain.hpp"
#include "render/typed.hpp"
#include "scene/scene_file.hpp"
#include "viewer/model/overlay/subtracted.hpp"
#include "viewer/model/state/setup_changes.hpp"

using namespace glassbox;
using namespace glassbox::test;

namespace {

const std::filesystem::path paper = std::filesystem::path(SCENES) / "levental-2014.toml";

/// Runs the command; our words contain nothing that a shell would quote.
nlohmann::json run(const std::string& command) {
    std::istringstream words(command);
    std::string word;
    words >> word;
    REQUIRE(word == "glassbox");
    Arguments arguments;
    while (words >> word) arguments.push_back(word);
    arguments.emplace_back("--json");
    const Folder folder;
    const Ran ran = run_glassbox(arguments, {.folder = folder.path});
    CAPTURE(command);
    CAPTURE(ran.err);
    REQUIRE(ran.status == 0);
    return nlohmann::json::parse(ran.out);
}

void check_same(const Setup& setup, Pixel pixel) {
    const Scene scene = read_scene(paper);
    const std::string command = explain_command(words_of(paper, scene, setup), pixel);
    CAPTURE(command);
    const Story story = explain(applied(scene, setup), setup.options, pixel.x, pixel.y);
    const nlohmann::json told = run(command);
    CHECK(told["color"] == nlohmann::json({story.color.red, story.color.green, story.color.blue}));
    REQUIRE(told["hit"].is_null() == !story.hit);
    if (story.hit) CHECK(told["hit"]["t"]["value"] == story.hit->t.value);
    // JSON holds all digits: the ray is the same to the bit.
    CHECK(told["ray"]["P"][0] == story.ray.P.x);
    CHECK(told["ray"]["P"][1] == story.ray.P.y);
    CHECK(told["ray"]["D"][0] == story.ray.D.x);
}

constexpr Pixel on_the_green_sphere{350, 149};

}  // namespace

TEST_CASE("as the scene says: no option but the pixel") {
    const Scene scene = read_scene(paper);
    CHECK(explain_command(words_of("s.toml", scene, setup_of(scene)), {1, 2}) == "glassbox explain s.toml --pixel 1,2");
    check_same(setup_of(scene), on_the_green_sphere);
}

TEST_CASE("each change comes back through the command line") {
    const Setup own = setup_of(read_scene(paper));
    Setup setup = own;
    setup.shading = {ShadingModel::phong,         1.0 / 3, 0.7, 0.123456789, 2.5, setup.shading.ambient_color,
                     setup.shading.specular_color};
    check_same(setup, on_the_green_sphere);
    setup = own;
    setup.light_vector = {-1e-3, 1.0 / 3, 1e20};
    setup.light_intensity = 0.1;
    check_same(setup, on_the_green_sphere);
    setup = with_figure(own, figures[2]);
    check_same(setup, {340, 160});
}

TEST_CASE("turns, rebuilt and accumulated, at every stage that knows them or not") {
    Setup setup = setup_of(read_scene(paper));
    for (int i = 0; i < 7; ++i) setup = turned(setup, Axis::z, 10);
    setup = turned(setup, Axis::y, -12.3);
    for (const bool accumulated : {false, true})
        for (const int stage : {4, 5}) {
            setup.options.accumulated = accumulated;
            setup.options.stage = stage;
            check_same(setup, {250, 250});
        }
}

TEST_CASE("scalars and rules") {
    Setup setup = setup_of(read_scene(paper));
    setup.options.scalar = Scalar::float_;
    setup.options.sphere_rule = Textbook{};
    setup.options.triangle_rule = Tolerance{0.1};
    check_same(setup, {375, 379});
    setup.options.scalar = Scalar::exact;
    setup.options.sphere_rule = Levental2014{};
    setup.options.triangle_rule = MoellerTrumbore{};
    setup.options.stage = 3;
    check_same(setup, {375, 379});
}

TEST_CASE("what is subtracted from the overlay comes with the commands; of words nothing is") {
    ViewerState state = opened(paper);
    state.overlay.measurement = "depth";
    subtract(state.overlay, minus("", "triangle:tolerance:0.5,scalar:exact"));
    CHECK(name_of(state.overlay) == "depth-minus-scalar:exact+triangle:tolerance:0.5");
    CHECK(command_to_measure(state, ".png")
              .ends_with(" --what depth --minus scalar:exact,triangle:tolerance:0.5 -o "
                         "levental-2014-depth-minus-scalar-exact+triangle-tolerance-0.5.png"));
    CHECK(command_to_view(state).ends_with(" --overlay depth --minus scalar:exact,triangle:tolerance:0.5"));

    // A range and a brush were for other values.
    state.overlay.range = {0, 1};
    state.overlay.brush = Brush{name_of(state.overlay), 0, 1};
    subtract(state.overlay, minus("", "scalar:float"));
    CHECK_FALSE(state.overlay.range);
    CHECK_FALSE(state.overlay.brush);

    state.overlay.measurement = "verdict";
    CHECK(name_of(state.overlay) == "verdict");
    CHECK(why_not_subtracted(state.overlay).starts_with("verdict is told in words"));
    CHECK(command_to_view(state).ends_with(" --overlay verdict"));
    state.overlay.measurement = "normal";
    CHECK(name_of(state.overlay) == "normal");
    CHECK(why_not_subtracted(state.overlay).starts_with("normal has 3 components"));
}

TEST_CASE("nothing, each scalar, rule and engine can be subtracted") {
    const std::vector<MinusChoice> all = minus_choices();
    REQUIRE(all.size() == 1 + 5 + 3 + 3 + 3);
    CHECK(all.front().name == "nothing");
    CHECK_FALSE(all.front().value);
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(written(*all[i].value) == all[i].name);
    CHECK(all[1].name == "scalar:certified");
}
