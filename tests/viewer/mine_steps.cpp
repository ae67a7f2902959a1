// The steps of a pixel by a learner's code: they are told as ours are, and where the code crashes, does not end or does
// not compile, all that can be known is told.
#include <doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "explain/explain.hpp"
#include "learn/prepared.hpp"
#include "output/folder.hpp"
#include "scene/scene_file.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/story/call_stack.hpp"
#include "viewer/model/story/lesson.hpp"
#include "viewer/model/story/stepping.hpp"
#include "viewer/model/story/steps_now.hpp"
#include "viewer/model/story/truth.hpp"
#include "viewer/model/work/background.hpp"
#include "viewer/script/script.hpp"

using namespace glassbox;
using learn::mine::Stand;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

/// A learner's folder, and a viewer without an interface that goes through the learner's steps.
struct Learner {
    test::Folder folder;
    test::Prepared prepared{folder / "my/.glassbox"};
    ViewerState state;
    Results results;
    Background background{[] {}};

    Learner() {
        ::unsetenv("CXX");  // by the compiler of this build: another evaluates operands in another order
        state = opened(ROOT "/scenes/levental-2014.toml");
        state.mine.folder = folder / "my";
        state.page = Page::steps;
    }

    /// Steps through this lesson at its stage, at the pixel in that column and row.
    void step(int lesson, int column, int row) {
        state.mine = chosen_mine(state.mine, lesson);
        REQUIRE(state.mine.problem == "");
        step_mine(state, true);
        Setup setup = state.setup.now();
        setup.options.stage = lesson;
        setup.options.scalar = Scalar::double_;
        state.setup.change(setup);
        pin(state, Pixel{column, 499 - row});
        settle();
    }
    void settle() {
        do {
            std::this_thread::sleep_for(2ms);
            background.update(state, results);
        } while (results.busy);
        background.update(state, results);
        follow_steps(state, results);
    }

    /// Saves a header: the solution, with one text replaced by another.
    void save(const std::string& lesson, const std::string& header, const std::string& instead_of = "",
              const std::string& put = "") {
        std::string text = test::content(fs::path(ROOT "/src/core") / lesson / header);
        const std::size_t at = text.find(instead_of);
        REQUIRE(at != std::string::npos);
        fs::create_directories(folder / "my" / lesson);
        std::ofstream(folder / "my" / lesson / header) << text.replace(at, instead_of.size(), put);
        ++state.mine.saved;  // as the interface's watch does
    }
    void solve(const std::string& lesson, std::initializer_list<const char*> headers) {
        for (const char* header : headers) save(lesson, header);
    }
    void solve_2() { solve("2-spheres", {"sphere.hpp", "quadratic.hpp", "crossing.hpp", "chord.hpp"}); }

    const MineSteps& mine() const { return results.mine_steps; }
    const learn::mine::RecordingUpdate& update() const { return mine().update; }
    const Event& last() const {
        REQUIRE(!mine().timeline.empty());
        return mine().timeline.back();
    }
    /// The line of a saved header that has this text, from 1.
    int line_of(const std::string& path, const std::string& wanted) const {
        const std::string text = test::content(folder / "my" / path);
        const std::size_t at = text.find(wanted);
        REQUIRE(at != std::string::npos);
        return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    }
};

void check_same(const std::vector<story::StoryStep>& mine, const std::vector<story::StoryStep>& ours) {
    REQUIRE(mine.size() == ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
        CAPTURE(i);
        CHECK(mine[i].step.operation == ours[i].step.operation);
        CHECK(mine[i].step.left == ours[i].step.left);
        CHECK(mine[i].step.right == ours[i].step.right);
        CHECK(mine[i].step.value == ours[i].step.value);
        CHECK(mine[i].step.line == ours[i].step.line);
        CHECK(mine[i].step.call == ours[i].step.call);
        CHECK(mine[i].name == ours[i].name);
        CHECK(mine[i].checked.error == ours[i].checked.error);
        CHECK(mine[i].checked.own_loss == doctest::Approx(ours[i].checked.own_loss));
    }
}

/// The learner's story of the pinned pixel has all that ours has.
void check_as_ours(const Learner& learner) {
    const auto& [mine, events, questions, serial] = static_cast<const Steps&>(learner.mine());
    CHECK(learner.update().words == "");
    CHECK(learner.update().stand == Stand::drawn);
    REQUIRE(mine);
    const Story ours = explain(applied(*learner.state.scene, learner.state.setup.now()),
                               learner.state.setup.now().options, learner.state.pinned->x, learner.state.pinned->y);
    CHECK(mine->ray.P == ours.ray.P);
    CHECK(mine->ray.D == ours.ray.D);
    CHECK(mine->color == ours.color);
    CHECK(mine->met == ours.met);
    CHECK(mine->not_listed == ours.not_listed);
    CHECK_FALSE(mine->ended);
    REQUIRE(mine->surfaces.size() == ours.surfaces.size());
    for (std::size_t i = 0; i < ours.surfaces.size(); ++i) {
        CAPTURE(i);
        CHECK(mine->surfaces[i].number == ours.surfaces[i].number);
        CHECK(mine->surfaces[i].fate == ours.surfaces[i].fate);
        CHECK(mine->surfaces[i].truly_met == ours.surfaces[i].truly_met);
        check_same(mine->surfaces[i].steps, ours.surfaces[i].steps);
    }
    REQUIRE(mine->hit.has_value() == ours.hit.has_value());
    if (ours.hit) {
        CHECK(mine->hit->tested_before == ours.hit->tested_before);
        check_same(mine->hit->steps, ours.hit->steps);
    }
    const std::vector<Event> told = timeline(ours);
    REQUIRE(events.size() == told.size());
    for (std::size_t i = 0; i < told.size(); ++i) {
        CHECK(events[i].group == told[i].group);
        CHECK(events[i].what == told[i].what);
        CHECK(events[i].formula == told[i].formula);
        CHECK(events[i].left_made_by == told[i].left_made_by);
    }
}

}  // namespace

TEST_CASE("lesson 2's solution is stepped as ours, on the learner's own lines") {
    Learner learner;
    learner.solve_2();
    learner.step(2, 350, 350);  // the middle of the green sphere
    check_as_ours(learner);

    // The first step that has a name of its own, in the learner's file.
    const std::vector<Event>& events = learner.mine().timeline;
    const auto delta = std::find_if(events.begin(), events.end(),
                                    [](const Event& event) { return event.formula.starts_with("Δ = "); });
    REQUIRE(delta != events.end());
    const std::vector<StackLine> stack = call_stack(*learner.mine().story, *delta);
    REQUIRE(stack.size() == 3);
    CHECK(stack[1].function == "Stable");  // ours, which calls the learner's
    CHECK(stack[1].file->path == "core/2-spheres/intersect_sphere.hpp");
    CHECK(stack[2].function == "discriminant");
    CHECK(stack[2].file->path == "my/2-spheres/chord.hpp");
    CHECK(code_of(stack[2]) == "return a * (r * r - dot(l, l));");
    CHECK(source_of(*learner.mine().story, *delta).file == stack[2].file);
    CHECK(lesson_of(*learner.mine().story, *delta).file == stack[2].file);

    // By the other rule, where nothing is met, and on the picture's border.
    Setup setup = learner.state.setup.now();
    setup.options.sphere_rule = Textbook{};
    learner.state.setup.change(setup);
    learner.settle();
    CHECK(learner.update().compile_seconds > 0);
    check_as_ours(learner);
    pin(learner.state, Pixel{10, 10});
    learner.settle();
    CHECK(learner.update().compile_seconds == 0);
    check_as_ours(learner);
    pin(learner.state, Pixel{0, 0});
    learner.settle();
    check_as_ours(learner);
}

TEST_CASE("so is lesson 3's, and those of rays, light and turns") {
    Learner learner;
    learner.solve("3-triangles", {"triangle.hpp", "pluecker.hpp", "sides.hpp"});
    learner.step(3, 370, 110);
    REQUIRE(learner.mine().story);
    REQUIRE(learner.mine().story->hit);
    check_as_ours(learner);
    const Event& some = learner.mine().timeline[learner.mine().timeline.size() / 2];
    CHECK(some.place);
    learner.solve("1-rays", {"vec3.hpp", "ray.hpp", "viewing_plane.hpp"});
    learner.step(1, 350, 350);
    check_as_ours(learner);
    learner.solve("4-shading", {"reflection.hpp"});
    learner.step(4, 350, 350);
    check_as_ours(learner);
    learner.solve("5-rotation", {"turn.hpp"});
    learner.step(5, 350, 350);
    check_as_ours(learner);
}

TEST_CASE("all that is written is stepped at once") {
    Learner learner;
    learner.solve_2();
    learner.solve("3-triangles", {"triangle.hpp", "pluecker.hpp", "sides.hpp"});
    learner.step(3, 350, 350);
    learner.state.mine.chosen = AllLessons{};
    learner.settle();
    check_as_ours(learner);
    CHECK(learner.mine().story->own->files().size() == 7);
}

TEST_CASE("a wrong answer is a step that failed") {
    Learner learner;
    learner.solve_2();
    // Always the smaller root: from inside a sphere nothing is met. The ray of column 350, row 350 starts at x = 500
    // and goes to −x; the sphere's centre is put there, so that it starts inside.
    Scene scene = *learner.state.scene;
    scene.spheres = {{{500, 350, 350}, 50, {0, 255, 0}}};
    scene.triangles.clear();
    learner.state.scene = std::make_shared<const Scene>(scene);
    learner.save("2-spheres", "crossing.hpp", "return choose(t0 > Real(0), t0, t1);", "return t0 + Real(0) * t1;");
    learner.step(2, 350, 350);
    REQUIRE(learner.mine().story);
    const auto failed = std::find_if(learner.mine().timeline.begin(), learner.mine().timeline.end(),
                                     [](const Event& event) { return event.failed; });
    REQUIRE(failed != learner.mine().timeline.end());
    CHECK(failed->what == "surface 0: missed: behind the start, t = −50 is not > 0; but truly it is met");
}

TEST_CASE("a crash is the last event, after the step and line where it happened") {
    Learner learner;
    learner.solve_2();
    learner.step(2, 350, 350);
    const std::size_t whole = learner.mine().timeline.size();
    const auto crash = [&](const std::string& line) {
        learner.save("2-spheres", "chord.hpp", "    const Real m = -dot(v, D);\n",
                     line + "\n    const Real m = -dot(v, D);\n");
        learner.settle();
    };
    crash("    double* volatile nowhere = nullptr;\n    *nowhere = 1;");
    CHECK(learner.update().stand == Stand::failed);
    CHECK(learner.update().words == "it followed a null pointer (address 0x0)");
    REQUIRE(learner.mine().story);
    // The last that was done is the last addition of D·D, whose call stands on the line above.
    const int vec3_line = [] {
        const std::string text = test::content(ROOT "/src/core/1-rays/vec3.hpp");
        const std::size_t at = text.find("return a.x * b.x + a.y * b.y + a.z * b.z;");
        REQUIRE(at != std::string::npos);
        return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    }();
    const Event end = learner.last();
    CHECK(end.failed);
    const std::string chord = "my/2-spheres/chord.hpp";
    const std::string own_line = chord + ":" + std::to_string(learner.line_of("2-spheres/chord.hpp", "Real a = dot"));
    CHECK(end.what ==
          "in `chord` of chord.hpp it followed a null pointer (address 0x0); the last step before that was "
          "done for " +
              own_line + ", at core/1-rays/vec3.hpp:" + std::to_string(vec3_line));
    REQUIRE(end.stopped_after);
    CHECK(end.stopped_after->row == 0u);  // in the first sphere's test
    const std::vector<StackLine> stack = call_stack(*learner.mine().story, end);
    REQUIRE(stack.size() == 4);
    CHECK(stack[2].function == "chord");
    CHECK(stack[2].file->path == "my/2-spheres/chord.hpp");
    CHECK(stack[2].line == static_cast<std::size_t>(learner.line_of("2-spheres/chord.hpp", "const Real a = dot")));
    // v has three differences and D·D three products and two sums; before them is that the ray is, and the test begins.
    CHECK(learner.mine().timeline.size() == 2 + 3 + 5 + 1);
    CHECK(learner.mine().timeline.size() < whole);
    CHECK(std::none_of(learner.mine().timeline.begin(), learner.mine().timeline.end(),
                       [](const Event& event) { return event.holds; }));  // there is no answer
    go(learner.state, learner.results, StepTo::next_failed);
    CHECK(learner.state.step == learner.mine().timeline.size() - 1);
    CHECK(level_now(learner.state, learner.results) == 2);  // the learner's line, not that of `dot`

    crash("    if (true) throw 7;");
    CHECK(learner.update().stand == Stand::failed);
    CHECK(learner.update().words == "it threw an exception that nobody caught: the number 7");
    CHECK(learner.last().what.starts_with("in `chord` of chord.hpp " + learner.update().words + "; the last step"));
    crash("    for (volatile bool on = true; on;) {}");
    CHECK(learner.update().words == "it ran for 3 s without ending: an endless loop?");
    CHECK(learner.mine().timeline.size() == 2 + 3 + 5 + 1);
    crash("    for (Real x = a; x > Real(0);) x = x * x;");
    CHECK(learner.update().words ==
          "it did not come to an end in 2000 steps: an endless loop, or a function that calls itself without end?");
    // Each round is a constant 0, which is no event, a comparison and a product: two thirds of 2000 steps are events.
    CHECK(learner.mine().timeline.size() > 1300);
    CHECK(learner.last().what.ends_with("without end? The last step before that was done at " + chord + ":" +
                                        std::to_string(learner.line_of("2-spheres/chord.hpp", "x = x * x"))));
    // Before anything is computed: there is no step, but the function is known.
    learner.save("2-spheres", "chord.hpp", "    const Vec3<Real> D = ray.D;\n",
                 "    double* volatile nowhere = nullptr;\n    *nowhere = 1;\n    const Vec3<Real> D = ray.D;\n");
    learner.settle();
    CHECK(learner.last().what == "in `chord` of chord.hpp it followed a null pointer (address 0x0)");
    CHECK(call_stack(*learner.mine().story, learner.last()).empty());

    // Later than all tests: in the normal.
    learner.save("2-spheres", "chord.hpp");
    learner.save("2-spheres", "sphere.hpp", "return unit(X - sphere.C);",
                 "double* volatile nowhere = nullptr;\n    *nowhere = 1;\n    return unit(X - sphere.C);");
    learner.settle();
    CHECK(learner.update().words == "it followed a null pointer (address 0x0)");
    REQUIRE(learner.mine().story);
    CHECK(learner.mine().story->hit);
    CHECK(learner.last().what.starts_with(
        "in `normal` of sphere.hpp it followed a null pointer (address 0x0); the last step "
        "before that was done at core/1-rays/"));  // the point's
    REQUIRE(learner.last().stopped_after);
    CHECK_FALSE(learner.last().stopped_after->row);
    CHECK(std::any_of(learner.mine().timeline.begin(), learner.mine().timeline.end(),
                      [](const Event& event) { return event.what.starts_with("nearest of 1 met"); }));

    learner.save("2-spheres", "sphere.hpp");
    learner.settle();
    CHECK(learner.update().stand == Stand::drawn);
    CHECK(learner.mine().timeline.size() == whole);
}

TEST_CASE("lesson 3, too: the tests before the crash are whole") {
    Learner learner;
    learner.solve("3-triangles", {"triangle.hpp", "pluecker.hpp", "sides.hpp"});
    learner.step(3, 370, 110);
    const std::size_t spheres = learner.state.scene->spheres.size();
    REQUIRE(learner.mine().story);
    const std::vector<story::Surface> whole = learner.mine().story->surfaces;
    // The second side of the first triangle is never found.
    learner.save("3-triangles", "sides.hpp", "return {side(D, B, C), ",
                 "const Real a = side(D, B, C);\n    double* volatile nowhere = nullptr;\n    *nowhere = 1;\n"
                 "    return {a, ");
    learner.settle();
    CHECK(learner.update().stand == Stand::failed);
    CHECK(
        learner.last().what.starts_with("in `sides` of sides.hpp it followed a null pointer (address 0x0); the last "
                                        "step before that was done for my/3-triangles/"));
    const Story& story = *learner.mine().story;
    REQUIRE(story.surfaces.size() == spheres + 1);
    for (std::size_t i = 0; i < spheres; ++i) check_same(story.surfaces[i].steps, whole[i].steps);
    CHECK_FALSE(story.surfaces.back().is_finished);
    CHECK(story.surfaces.back().steps.size() < whole[spheres].steps.size());
    CHECK_FALSE(story.hit);
}

TEST_CASE("what does not compile, or not in recorded numbers, is told with what to do") {
    Learner learner;
    learner.step(2, 350, 350);
    CHECK(learner.update().stand == Stand::not_there);
    CHECK(learner.update().words.find("2-spheres is not begun") != std::string::npos);
    CHECK_FALSE(learner.mine().story);

    learner.solve_2();
    const learn::Workspace& workspace = *learner.state.mine.workspace;
    const learn::Exercise& spheres = learn::exercise_called(workspace, "2");
    std::ofstream(learner.folder / "my/2-spheres/chord.hpp") << workspace.starter(spheres, "chord.hpp");
    ++learner.state.mine.saved;
    learner.settle();
    CHECK(learner.update().stand == Stand::not_written);
    CHECK(learner.update().words.find("`chord` is not written yet (") == 0);
    CHECK(learner.last().what.find("`chord` is not written yet (") == 0);

    learner.save("2-spheres", "chord.hpp", "const Real m = -dot(v, D);", "const Real m = -dott(v, D);");
    learner.settle();
    CHECK(learner.update().stand == Stand::does_not_compile);
    REQUIRE(learner.update().error);
    CHECK(learner.update().error->place.line ==
          static_cast<std::size_t>(learner.line_of("2-spheres/chord.hpp", "dott")));
    CHECK(learner.update().words.find("dott") != std::string::npos);
    CHECK(learner.update().words.find("write `Real`") == std::string::npos);

    learner.save("2-spheres", "chord.hpp", "const Real m = -dot(v, D);", "const double m = -dot(v, D);");
    learner.settle();
    CHECK(learner.update().stand == Stand::does_not_compile);
    REQUIRE(learner.update().error);
    CHECK(learner.update().error->yours);
    CHECK(learner.update().error->place.line ==
          static_cast<std::size_t>(learner.line_of("2-spheres/chord.hpp", "double m")));
    CHECK(learner.update().words.find("chord.hpp:") != std::string::npos);
    CHECK(learner.update().words.find("; it compiles in double, but steps are recorded in numbers of our own: write "
                                      "`Real`") != std::string::npos);

    learner.save("2-spheres", "chord.hpp");
    learner.settle();
    check_as_ours(learner);

    learner.solve("6-rounding", {"bounded.hpp", "magnitude.hpp", "filter.hpp"});
    learner.step(6, 350, 350);
    CHECK(learner.update().stand == Stand::not_there);
    CHECK(learner.update().words.find("the steps of 6-rounding cannot be recorded") == 0);
}

TEST_CASE("ours and mine: by key, by click and by script; the tiles and the questions are about ours") {
    Learner learner;
    learner.solve_2();
    learner.step(2, 350, 350);
    ViewerState& state = learner.state;
    Results& results = learner.results;
    REQUIRE(results.story);
    REQUIRE(results.mine_steps.story);
    CHECK(steps_now(state, results).story == results.mine_steps.story);
    obey({Key::end, 0, false, false}, state, results);
    CHECK(state.step == results.mine_steps.timeline.size() - 1);
    CHECK_FALSE(row_to_nudge(state, results));
    obey({Key::character, '/', false, false}, state, results);
    CHECK_FALSE(state.mine.is_stepped);
    CHECK(state.step == 0);
    CHECK(steps_now(state, results).story == results.story);
    obey({Key::character, '/', false, false}, state, results);
    CHECK(state.mine.is_stepped);
    open_tile(state, results, TileKind::search);
    CHECK_FALSE(state.mine.is_stepped);
    learner.settle();
    CHECK_FALSE(results.mine_steps.story);  // what is not shown is not kept

    ViewerState shown = opened(ROOT "/scenes/levental-2014.toml");
    shown.mine.folder = learner.folder / "my";
    HiddenViewer viewer(std::move(shown), {1000, 800});
    for (const char* line : {"set lesson 2", "pin 350,149", "set steps-of mine", "step last"}) {
        for (const script::Command& command : script::read(line, "script"))
            std::get<script::ChangeState>(command).change(viewer.state(), viewer.results());
        viewer.settle();
    }
    CHECK(viewer.state().step == viewer.results().mine_steps.timeline.size() - 1);
    for (const StepsPane pane : {StepsPane::source, StepsPane::formula, StepsPane::losses, StepsPane::nudge}) {
        viewer.state().stepping.pane = pane;
        viewer.settle();
    }
    learner.save("2-spheres", "chord.hpp", "    const Real m = -dot(v, D);\n", "    throw 7;\n    const Real m = a;\n");
    ++viewer.state().mine.saved;
    viewer.settle();
    CHECK(viewer.results().mine_steps.timeline.back().failed);
    learner.save("2-spheres", "chord.hpp", "const Real m", "const double m");
    ++viewer.state().mine.saved;
    viewer.settle();
    CHECK(viewer.results().mine_steps.update.stand == Stand::does_not_compile);
    CHECK(viewer.screen().complaints() == 0);
}
