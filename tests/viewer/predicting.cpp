// Predict, then step: what of the timeline may be seen, and what keys and scripts answer. Which questions there are is
// tested in tests/explain/questions.cpp.
#include "viewer/model/story/predicting.hpp"

#include <doctest.h>

#include <fstream>

#include "cli/program.hpp"
#include "explain/explain.hpp"
#include "scene/scene_file.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/playing.hpp"

using namespace glassbox;
using test::Folder;

namespace {

/// A pixel of the paper's scene, as the background shows it: surface 0 is met, and events 0 and 1 are before its test.
struct Pinned {
    ViewerState state;
    Results results;

    explicit Pinned(const Options& options = {}, double far = 0) {
        state.page = Page::steps;
        show(options, far);
    }
    void show(const Options& options, double far) {
        Scene scene = read_scene(SCENES "/levental-2014.toml");
        if (far > 0) {
            scene.triangles.clear();
            scene.spheres = {{{100 - far, 350, 350}, 50, {0, 255, 0}}};
        }
        results.story = std::make_shared<const Story>(explain(scene, options, 350, 149));
        results.timeline = timeline(*results.story);
        results.questions = questions(*results.story, results.timeline);
        ++results.story_serial;
    }
    void press(char32_t character) { obey({Key::character, character, false, false}, state, results); }
    std::size_t shown() const { return steps_shown(state, results).size(); }
};

Image window_with(const std::string& scene, bool predict) {
    const Folder folder;
    std::ofstream(folder / "s.toml") << scene;
    ViewerState state = opened(folder / "s.toml");
    state.page = Page::steps;
    state.space_shown = false;
    pin(state, Pixel{20, 20});
    set_predicting(state, {}, predict);
    HiddenViewer viewer(std::move(state), {900, 700});
    viewer.settle();
    return viewer.screen().screenshot();
}

/// How many pixels of the right third, all of it the page, differ.
int differing(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 60; y < a.height - 40; ++y)
        for (int x = a.width * 2 / 3; x < a.width; ++x) count += a.at(x, y) != b.at(x, y);
    return count;
}

}  // namespace

TEST_CASE("the steps end at the next question; keys answer it, and mean what they meant elsewhere") {
    Pinned pinned;
    ViewerState& state = pinned.state;
    const std::size_t all = pinned.results.timeline.size();
    CHECK(pinned.shown() == all);
    CHECK(next_question(state, pinned.results) == nullptr);
    state.step = 40;
    pinned.press('p');
    CHECK(state.predicting.on);
    CHECK(state.step == 0);
    CHECK(pinned.shown() == 2);
    CHECK(open_question(state, pinned.results) == nullptr);
    pinned.press('h');  // nothing is asked here yet
    CHECK(state.predicting.answers.empty());
    obey({Key::end, 0, false, false}, state, pinned.results);
    CHECK(state.step == 1);
    REQUIRE(open_question(state, pinned.results));
    pinned.press('+');  // is no answer to hit or miss
    CHECK(state.predicting.answers.empty());
    pinned.press('m');
    CHECK(state.predicting.answers == Answers{0});
    CHECK(state.beside == Beside::nothing);
    CHECK(score_so_far(state) == Score{0, 0});  // the verdict is not seen yet
    pinned.press('+');
    CHECK(score_so_far(state) == Score{1, 1});
    CHECK(pinned.shown() > 2);

    // Playing stops at the question, too.
    play_or_pause(state, pinned.results);
    go_on_playing(state, pinned.results, 1e6);
    CHECK_FALSE(state.playing);
    CHECK(state.step + 1 == pinned.shown());
    pinned.press('k');
    CHECK(score_so_far(state) == Score{1, 2});  // skipped; but now the verdict is seen, and it is a hit

    // To another page the keys mean what they always do.
    state.page = Page::overlay;
    state.step = pinned.shown() - 1;
    const double zoom = state.view.zoom;
    pinned.press('+');
    CHECK(state.view.zoom > zoom);

    // Another story begins anew, and the score goes on.
    pinned.show({}, 0);
    follow_story(state, pinned.results);
    CHECK(state.step == 0);
    CHECK(state.predicting.answers.empty());
    CHECK(score_so_far(state) == Score{1, 2});
    set_predicting(state, pinned.results, false);
    CHECK(pinned.shown() == all);
}

// The sphere ten millions away: in float all bits of Δ are lost. Its step is seen, how much it loses is not.
TEST_CASE("a cancellation is not marked before the reader has said how many bits it loses") {
    Options options;
    options.scalar = Scalar::float_;
    options.sphere_rule = Textbook{};
    Pinned pinned(options, 9999600);
    set_predicting(pinned.state, pinned.results, true);
    const auto is_bits = [](const Question* question) { return question && question->asked == Asked::bits; };
    while (next_question(pinned.state, pinned.results) && !is_bits(next_question(pinned.state, pinned.results))) {
        pinned.state.step = pinned.shown() - 1;
        answer(pinned.state, pinned.results, {});
    }
    REQUIRE(is_bits(next_question(pinned.state, pinned.results)));
    const std::size_t step = pinned.shown() - 1;
    CHECK(pinned.results.timeline[step].cancellation);
    CHECK(hides_loss(pinned.state, pinned.results, step));
    CHECK_FALSE(hides_loss(pinned.state, pinned.results, step - 1));
    pinned.state.step = step;
    answer(pinned.state, pinned.results, pinned.results.questions[pinned.state.predicting.answers.size()].right);
    CHECK_FALSE(hides_loss(pinned.state, pinned.results, step));
    CHECK(score_so_far(pinned.state).right >= 1);
}

// Two scenes, the same up to the first sphere. Then one ray meets a second sphere, and the other misses it.
TEST_CASE("nothing on the page depends on what is not yet to be seen") {
    const std::string begins = R"(
[image]
width = 40
height = 40
[view]
corner = [500, 0, 0]
[[sphere]]
center = [100, 20, 20]
radius = 9
[[sphere]]
radius = 5
center = )";
    const std::string met = begins + "[300, 20, 20]\n", missed = begins + "[300, 90, 20]\n";
    CHECK(differing(window_with(met, false), window_with(missed, false)) > 100);
    CHECK(differing(window_with(met, true), window_with(missed, true)) == 0);
}

TEST_CASE("in a script") {
    const Folder folder;
    const auto run = [&](const std::string& script) {
        test::write(folder / "a.script", "set space off\npin 350,149\nset predict on\n" + script);
        return test::run_glassbox({"view", "--script", "a.script", "--size", "700x600"}, {.folder = folder.path});
    };
    CHECK(run("predict hit\npredict +\npredict skip\nkey p\nset predict off\n").status == 0);
    const test::Ran wrong = run("predict 12\n");
    CHECK(wrong.status == 1);
    CHECK(wrong.err.find("a.script:4:1: error: predict: '12' is no answer to: surface 0") != std::string::npos);
    const test::Ran nothing = run("set predict off\npredict hit\n");
    CHECK(nothing.status == 1);
    CHECK(nothing.err.find("nothing is asked; put 'set predict on'") != std::string::npos);
}
