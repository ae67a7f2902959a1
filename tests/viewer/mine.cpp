// The learner's picture in the viewer: what is computed, what stays while a new one is made, and that nothing in it can
// stop the rest. How each kind of end is described is tested in tests/learn/mine.cpp.
#include "viewer/model/work/mine.hpp"

#include <doctest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "learn/picture/maker.hpp"
#include "learn/prepared.hpp"
#include "output/folder.hpp"
#include "scene/error.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/background.hpp"
#include "viewer/model/work/file_watch.hpp"

using namespace glassbox;
using learn::mine::Stand;
using test::Folder;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr const char* two_spheres = R"(
[image]
width = 40
height = 30
[view]
corner = [500, 0, 0]
[[sphere]]
center = [100, 20, 15]
radius = 9
color = [0, 255, 0]
[[sphere]]
center = [50, 8, 8]
radius = 4
color = [255, 0, 0]
)";

/// A viewer without an interface, and a learner's folder.
struct Viewer {
    Folder folder;
    test::Prepared prepared{folder / "my/.glassbox"};
    ViewerState state;
    Results results;
    Background background{[] {}};

    Viewer() {
        std::ofstream(folder / "scene.toml") << two_spheres;
        state = opened(folder / "scene.toml");
        state.mine.folder = folder / "my";
    }

    /// Waits until everything that was requested is there.
    void settle() {
        do {
            std::this_thread::sleep_for(2ms);
            background.update(state, results);
        } while (results.busy);
        background.update(state, results);
    }

    /// Saves a header of lesson 2: the solution, with one text replaced by another.
    void save(const std::string& header, const std::string& instead_of = "", const std::string& put = "") {
        std::string text = test::content(fs::path(ROOT "/src/core/2-spheres") / header);
        const std::size_t at = text.find(instead_of);
        REQUIRE(at != std::string::npos);
        fs::create_directories(folder / "my/2-spheres");
        std::ofstream(folder / "my/2-spheres" / header) << text.replace(at, instead_of.size(), put);
        ++state.mine.saved;  // as the interface's watch does
    }
    bool same_as_ours() const { return results.other.image->pixels == results.picture.image->pixels; }
};

}  // namespace

TEST_CASE("it is looked at in double, at the lesson's stage, and undo takes that back") {
    Viewer viewer;
    const Setup before = viewer.state.setup.now();
    show_mine(viewer.state, 2);
    CHECK(viewer.state.mine.problem == "");
    CHECK(viewer.state.beside == Beside::mine);
    CHECK(viewer.state.setup.now().options.scalar == Scalar::double_);
    CHECK(viewer.state.setup.now().options.stage == 2);
    const std::vector<fs::path> files = files_of(viewer.state.mine);
    REQUIRE(files.size() == 4);
    CHECK(files[0] == viewer.folder / "my/2-spheres/sphere.hpp");
    viewer.state.setup.undo();
    CHECK(viewer.state.setup.now() == before);

    viewer.state.beside = Beside::mine_difference;
    show_mine(viewer.state, 5);  // the difference stays, of another lesson
    CHECK(viewer.state.beside == Beside::mine_difference);
    CHECK(viewer.state.mine.chosen == LessonChoice(5));

    std::ofstream(viewer.folder / "other.toml") << "[image]\nwidth = 9\nheight = 7\n";
    open(viewer.state, viewer.folder / "other.toml");
    CHECK(viewer.state.beside == Beside::mine_difference);
    CHECK(viewer.state.mine.chosen == LessonChoice(5));
    CHECK(viewer.state.setup.now().options.scalar == Scalar::double_);

    show_mine(viewer.state, 77);
    CHECK(viewer.state.mine.problem.find("there is no lesson '77'") == 0);
    toggle_mine(viewer.state);
    CHECK(viewer.state.beside == Beside::nothing);
    // As the file says again, which names no scalar: certified.
    CHECK(viewer.state.setup.now().options.scalar == Scalar::certified);
    toggle_mine(viewer.state);  // the last one shown
    CHECK(viewer.state.setup.now().options.scalar == Scalar::double_);
    Setup chosen = viewer.state.setup.now();
    chosen.options.scalar = Scalar::float_;
    viewer.state.setup.change(chosen);
    toggle_mine(viewer.state);  // what was chosen meanwhile stays
    CHECK(viewer.state.setup.now().options.scalar == Scalar::float_);
    show_beside(viewer.state, Beside::mine);
    show_beside(viewer.state, Beside::other);
    CHECK(viewer.state.setup.now().options.scalar == Scalar::float_);
    show_beside(viewer.state, Beside::mine);
    CHECK(viewer.state.mine.chosen == LessonChoice(5));
    CHECK(viewer.state.mine.problem == "");
}

TEST_CASE("all that is written: in double, at the last stage, tested lesson by lesson") {
    Viewer viewer;
    const auto& mine = viewer.results.mine;
    const Setup before = viewer.state.setup.now();
    CHECK(read_lesson_choice("all") == LessonChoice(AllLessons{}));
    CHECK(read_lesson_choice("7") == LessonChoice(7));
    for (const char* wrong : {"", "0", "-1", "2x", " 2", "ALL", "99999999999"}) CHECK_FALSE(read_lesson_choice(wrong));
    show_mine(viewer.state, AllLessons{});
    CHECK(viewer.state.mine.problem == "");
    CHECK(viewer.state.beside == Beside::mine);
    CHECK(viewer.state.setup.now().options.scalar == Scalar::double_);
    CHECK(viewer.state.setup.now().options.stage == 5);
    CHECK(exercise_of(viewer.state.mine) == nullptr);
    // Any of them, saved, may finish its lesson.
    const std::vector<fs::path> files = files_of(viewer.state.mine);
    for (const char* file : {"1-rays/vec3.hpp", "2-spheres/chord.hpp", "3-triangles/sides.hpp",
                             "4-shading/reflection.hpp", "5-rotation/turn.hpp"})
        CHECK(std::find(files.begin(), files.end(), viewer.folder / "my" / file) != files.end());
    CHECK(std::find(files.begin(), files.end(), viewer.folder / "my/6-rounding/filter.hpp") == files.end());
    viewer.state.setup.undo();
    CHECK(viewer.state.setup.now() == before);
    viewer.state.setup.redo();

    viewer.state.mine.is_tested = true;
    viewer.settle();
    REQUIRE(mine);
    CHECK(mine->stand == Stand::not_there);
    CHECK(viewer.results.tests == nullptr);
    for (const char* header : {"sphere.hpp", "quadratic.hpp", "crossing.hpp", "chord.hpp"}) viewer.save(header);
    viewer.settle();
    CHECK(mine->stand == Stand::drawn);
    CHECK(mine->by_whom == "drawn by lesson 2 of yours; the rest is ours");
    CHECK(viewer.same_as_ours());
    CHECK(viewer.results.tests == nullptr);

    open(viewer.state, viewer.state.file);
    CHECK(is_of_all(viewer.state.mine));
    CHECK(viewer.state.setup.now().options.stage == 5);
    toggle_mine(viewer.state);
    toggle_mine(viewer.state);
    CHECK(is_of_all(viewer.state.mine));

    // The page that says so.
    ViewerState shown = viewer.state;
    shown.page = Page::mine;
    HiddenViewer window(std::move(shown), {900, 700});
    window.settle();
    REQUIRE(window.results().mine);
    CHECK(window.results().mine->stand == Stand::drawn);
    CHECK(window.results().tests == nullptr);
    CHECK(window.screen().complaints() == 0);
}

TEST_CASE("a learner's day: nothing yet, a picture, a slip, a crash, and all is well again") {
    Viewer viewer;
    const auto& [picture, other, mine] = std::tie(viewer.results.picture, viewer.results.other, viewer.results.mine);
    show_mine(viewer.state, 2);
    viewer.settle();
    REQUIRE(mine);
    CHECK(mine->stand == Stand::not_there);
    CHECK(mine->words.find("'./glassbox learn test 2'") != std::string::npos);
    CHECK(other.image == nullptr);

    for (const char* header : {"sphere.hpp", "quadratic.hpp", "crossing.hpp", "chord.hpp"}) viewer.save(header);
    viewer.settle();
    CHECK(mine->stand == Stand::drawn);
    REQUIRE(other.image);
    CHECK(other.factor == 1);
    CHECK(viewer.same_as_ours());

    // A compile error: the last picture stays, and the place of the mistake is known.
    viewer.save("sphere.hpp", "return unit(X - sphere.C);", "return unit(X - sphere.C)");
    viewer.settle();
    CHECK(mine->stand == Stand::does_not_compile);
    REQUIRE(mine->error);
    CHECK(mine->error->yours);
    CHECK(mine->drawing == nullptr);
    CHECK(viewer.same_as_ours());

    // A crash at one pixel is reported, and the rest of the viewer works. Column 20, row 13 is pixel (20, 16): 30 rows.
    viewer.save("sphere.hpp");
    viewer.save(
        "chord.hpp", "const Real a = dot(D, D);",
        "const Real a = dot(D, D); if (ray.P.y == 20 && ray.P.z == 13) *static_cast<volatile int*>(nullptr) = 1;");
    viewer.state.pinned = Pixel{20, 16};
    viewer.settle();
    CHECK(mine->stand == Stand::failed);
    CHECK(mine->words == "at pixel (20, 16) it followed a null pointer (address 0x0)");
    CHECK(mine->spot == Pixel{20, 16});
    REQUIRE(mine->drawing);
    CHECK(other.image.get() == &mine->drawing->image);
    CHECK(other.factor == 2);  // not all of it is there
    REQUIRE(viewer.results.story);
    CHECK(viewer.results.error == "");

    // Another stage and a turn need no compiler, and crash no less.
    Setup setup = turned(viewer.state.setup.now(), Axis::z, 10);
    setup.options.stage = 4;
    viewer.state.setup.change(setup);
    viewer.settle();
    CHECK(mine->compile_seconds == 0);
    CHECK(mine->stand == Stand::failed);  // at stage 4 the view is not turned yet
    CHECK(viewer.results.picture.image->width == 40);

    viewer.save("chord.hpp");
    viewer.settle();
    CHECK(mine->stand == Stand::drawn);
    CHECK(viewer.same_as_ours());

    // While it is not shown, it is not computed, and what is shown beside ours is not mistaken for something else.
    const auto mines = other.image;
    viewer.state.beside = Beside::other;
    viewer.background.update(viewer.state, viewer.results);
    CHECK(mine == nullptr);
    CHECK(other.image != mines);  // nothing yet, or the other one already
    viewer.settle();
    REQUIRE(other.image);
    toggle_mine(viewer.state);
    viewer.background.update(viewer.state, viewer.results);
    CHECK(other.image == nullptr);
    viewer.settle();
    CHECK(mine->stand == Stand::drawn);
    CHECK(mine->compile_seconds == 0);
}

// The mistake far-root-missing always takes the smaller t. So of −7 and 3, where 3 is ahead, −7 comes out; and from the
// middle of a sphere of radius 5 about the origin, where t is −5 and 5, nothing is met.
TEST_CASE("its tests at each save, listed as learn tells them; the ray of one that fails is pinned") {
    using Tests = learn::ToldTests::Stand;
    Viewer viewer;
    ViewerState& state = viewer.state;
    const auto& tests = viewer.results.tests;
    const fs::path scene = state.file;
    show_mine(state, 2);
    viewer.settle();
    CHECK(tests == nullptr);  // nobody has opened the page
    state.mine.is_tested = true;
    viewer.settle();
    REQUIRE(tests);
    CHECK(tests->stand == Tests::not_there);
    CHECK(tests->words.find("'./glassbox learn test 2'") != std::string::npos);

    for (const char* header : {"sphere.hpp", "quadratic.hpp", "chord.hpp"}) viewer.save(header);
    viewer.save("crossing.hpp", "return choose(t0 > Real(0), t0, t1);", "return t0 + Real(0) * t1;");
    viewer.settle();
    CHECK(tests->stand == Tests::done);
    CHECK_FALSE(tests->passed);
    CHECK(tests->words.find(" tests fail") != std::string::npos);
    const auto row = [](const std::vector<learn::ToldRow>& rows, const std::string& name) {
        for (const learn::ToldRow& one : rows)
            if (one.name == name) return one.value;
        return std::string();
    };
    const std::string no_ray = "first_ahead: the smaller t where it is above 0, else the larger";
    const learn::ToldCase* const bare = find_case(*tests, no_ray);
    REQUIRE(bare);
    CHECK(bare->state == learn::State::failing);
    CHECK(bare->scalars == std::vector<std::string>{"double", "float"});
    CHECK(row(bare->rows, "expected") == "3 (0x1.8p+1)");  // 1.5·2
    CHECK(row(bare->rows, "got") == "-7 (-0x1.cp+2)");     // 1.75·4
    CHECK_FALSE(bare->ray);
    CHECK(tests->first == no_ray);  // the first function at fault
    REQUIRE_FALSE(tests->about_first.empty());
    CHECK(tests->about_first[0].name == "This looks familiar.");
    const auto function = std::find_if(tests->functions.begin(), tests->functions.end(),
                                       [](const learn::ToldFunction& f) { return f.name == "first_ahead"; });
    REQUIRE(function != tests->functions.end());
    CHECK(function->state == learn::State::failing);

    // One without a ray is chosen, and the scene stays.
    look_at(state, *bare);
    CHECK(state.mine.test == no_ray);
    CHECK(state.file == scene);
    CHECK_FALSE(state.looked_at);

    const learn::ToldCase* const traced =
        find_case(*tests, "Stable: a sphere about the origin is met where it should be");
    REQUIRE(traced);
    REQUIRE(traced->ray);
    look_at(state, *traced);
    CHECK(state.file_error == "");
    CHECK(state.pinned == traced->ray->pixel);
    REQUIRE(state.looked_at);
    CHECK(state.looked_at->test == traced->name);
    CHECK(row(expected_and_got(state.looked_at->rows), "checked") == "crossing.met");
    CHECK(row(expected_and_got(state.looked_at->rows), "got") == "false");
    CHECK(shows_mine(state));
    CHECK(state.setup.now().options.sphere_rule == SphereRule(Stable{}));
    viewer.settle();
    REQUIRE(viewer.results.story);
    CHECK(viewer.results.story->ray.P == Vec3<double>{0, 0, 0});
    REQUIRE(viewer.results.story->hit);
    CHECK(viewer.results.story->hit->t.value == 5);  // that is what ours says

    // Another one is looked at by key, and the way back leads to the scene that was there.
    obey({Key::character, 't', false, false}, state, viewer.results);
    CHECK(state.page == Page::mine);
    CHECK(state.mine.test != traced->name);
    obey({Key::character, 't', false, true}, state, viewer.results);
    CHECK(state.mine.test == traced->name);
    obey({Key::character, 'g', false, false}, state, viewer.results);
    CHECK(state.file == scene);
    CHECK_FALSE(state.looked_at);

    viewer.save("sphere.hpp", "return unit(X - sphere.C);", "return unit(X - sphere.C)");
    viewer.settle();
    CHECK(tests->stand == Tests::does_not_compile);
    CHECK(tests->words.find("2-spheres/sphere.hpp:") != std::string::npos);
    CHECK(tests->words.ends_with(": this does not compile"));
    REQUIRE(tests->error);
    CHECK(tests->error->yours);

    viewer.save("sphere.hpp");
    viewer.save("crossing.hpp");
    bool ran = false;
    do {
        std::this_thread::sleep_for(1ms);
        viewer.background.update(state, viewer.results);
        ran = ran || tests->stand == Tests::running;
    } while (viewer.results.busy);
    CHECK(ran);  // and it was told
    CHECK(tests->passed);
    CHECK(tests->words.starts_with("All "));
    CHECK(tests->first == "");

    // Stopped with the picture, in the middle of the work.
    viewer.save("crossing.hpp", "return choose(t0 > Real(0), t0, t1);", "return t0 + Real(0) * t1;");
    viewer.background.update(state, viewer.results);
    toggle_mine(state);
    viewer.settle();
    CHECK(tests == nullptr);
}

TEST_CASE("a click on a failing test opens its ray; the page is drawn in each state") {
    Viewer model;
    for (const char* header : {"sphere.hpp", "quadratic.hpp", "chord.hpp"}) model.save(header);
    model.save("crossing.hpp", "return choose(t0 > Real(0), t0, t1);", "return t0 + Real(0) * t1;");
    model.state.page = Page::mine;
    HiddenViewer viewer(std::move(model.state), {900, 700});
    viewer.settle();
    CHECK(viewer.results().tests == nullptr);  // nothing of the learner's is shown yet
    show_mine(viewer.state(), 2);
    viewer.settle();
    REQUIRE(viewer.results().tests);
    CHECK(viewer.results().tests->stand == learn::ToldTests::Stand::done);
    viewer.state().mine.test = "Stable: a sphere about the origin is met where it should be";  // the list goes there
    viewer.settle();
    // On the right is the page, below the tiles and the tabs; the list, then the details.
    Pointer mouse{800, 0};
    for (mouse.y = 270; mouse.y < 560 && !viewer.state().looked_at; mouse.y += 6) {
        viewer.frame(mouse);
        mouse.left = true;
        viewer.frame(mouse);
        mouse.left = false;
        viewer.frame(mouse);
    }
    REQUIRE(viewer.state().looked_at);
    CHECK(viewer.state().file.string().find(".glassbox/failing/") != std::string::npos);
    viewer.settle();
    CHECK(viewer.results().story);
    for (const Page page : {Page::steps, Page::inspector, Page::mine}) {
        viewer.state().page = page;
        viewer.settle();
    }
    CHECK(viewer.screen().complaints() == 0);
}

TEST_CASE("a file that is written, taken away or put back has changed") {
    const Folder folder;
    // In one step: a file that is seen first empty and then full has changed twice.
    const auto write = [&](const char* name, const char* text) {
        std::ofstream(folder / "new") << text;
        fs::rename(folder / "new", folder / name);
    };
    write("a", "a");
    const std::vector<fs::path> files{folder / "a", folder / "b"};
    FileWatch any(files, FileWatch::Gone::is_a_change, [] {});
    FileWatch written(files, FileWatch::Gone::is_no_change, [] {});
    const auto changed = [](FileWatch& watch, std::chrono::milliseconds within) {
        for (const auto end = std::chrono::steady_clock::now() + within; std::chrono::steady_clock::now() < end;) {
            if (watch.has_changed()) return true;
            std::this_thread::sleep_for(10ms);
        }
        return false;
    };
    CHECK(!changed(any, 400ms));
    write("b", "new");
    CHECK(changed(any, 10s));
    CHECK(changed(written, 10s));
    fs::remove(folder / "a");
    CHECK(changed(any, 10s));
    CHECK(!changed(written, 400ms));
    write("a", "back");
    CHECK(changed(any, 10s));
    CHECK(changed(written, 10s));
}
