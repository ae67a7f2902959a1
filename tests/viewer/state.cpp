// What is chosen: setups, scenes that are opened and read again.
#include "viewer/model/state/state.hpp"

#include <doctest.h>

#include <fstream>

#include "output/folder.hpp"
#include "render/render.hpp"
#include "viewer/model/state/first_pin.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/tour.hpp"

using namespace glassbox;
using test::Folder;

namespace {

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

const std::string small = "title = 'small'\n[image]\nwidth = 20\nheight = 10\n";

}  // namespace

TEST_CASE("reading a file again keeps pins and changes, and the rest follows the file") {
    const Folder folder;
    const auto file = folder / "s.toml";
    write(file, small + "[shading]\nambient = 0.1\ndiffuse = 0.2\n");
    ViewerState state = opened(file);
    state.pinned = Pixel{3, 4};
    state.compared = Pixel{19, 9};
    Setup setup = state.setup.now();
    setup.shading.k_a = 0.9;
    state.setup.change(turned(setup, Axis::z, 10));
    setup.shading.k_a = 0.8;
    state.setup.change(setup);
    state.setup.undo();

    write(file, "[image]\nwidth = 19\nheight = 10\n[shading]\nambient = 0.3\ndiffuse = 0.4\n[light]\nintensity = 2\n");
    reload(state);
    CHECK(state.file_error == "");
    CHECK(state.scene->width == 19);
    CHECK(state.pinned == Pixel{3, 4});
    CHECK_FALSE(state.compared);  // column 19 is gone
    CHECK(state.setup.now().shading.k_a == 0.9);
    CHECK(state.setup.now().shading.k_d == 0.4);
    CHECK(state.setup.now().light_intensity == 2);
    CHECK(state.setup.now().options.turns == std::vector<Turn<double>>{{Axis::z, 10}});
    // Undo and redo are still there, and know the new file.
    state.setup.redo();
    CHECK(state.setup.now().shading.k_a == 0.8);
    CHECK(state.setup.now().shading.k_d == 0.4);
    state.setup.undo();
    state.setup.undo();
    CHECK(state.setup.now() == setup_of(*state.scene));
}

TEST_CASE("an error in the file keeps the last good scene, until it is good again") {
    const Folder folder;
    const auto file = folder / "s.toml";
    write(file, small);
    ViewerState state = opened(file);
    state.pinned = Pixel{1, 1};
    const auto good = state.scene;
    write(file, "[image]\nwidth = -1\n");
    reload(state);
    // The number stands in line 2, from column 9 on.
    CHECK(state.file_error.find("s.toml:2:9: error: ") != std::string::npos);
    CHECK(state.scene == good);
    CHECK(state.pinned == Pixel{1, 1});
    // Nested so deeply that the stack would overflow: the viewer goes on.
    std::string deep = "a";
    for (int k = 0; k < 40000; ++k) deep += ".b";
    for (const std::string& text : {deep + " = 1\n", "[" + deep + "]\n", "a = " + std::string(40000, '[')}) {
        write(file, text);
        reload(state);
        CHECK(state.file_error.find("more than 100 levels deep") != std::string::npos);
        CHECK(state.scene == good);
    }
    std::filesystem::remove(file);
    reload(state);
    CHECK(state.file_error.find("s.toml") != std::string::npos);
    CHECK(state.scene == good);
    write(file, small);
    reload(state);
    CHECK(state.file_error == "");
    CHECK(state.scene != good);
}

TEST_CASE(
    "opening another scene forgets pins and changes, and keeps how things look; one that is bad changes nothing") {
    const Folder folder;
    write(folder / "a.toml", small);
    write(folder / "b.toml", "title = 'other'\n");
    ViewerState state = opened(folder / "a.toml");
    state.pinned = Pixel{1, 1};
    state.appearance.dark = false;
    state.page = Page::controls;
    state.side_width = .6f;
    state.scene_menu.folder = folder.path;
    state.setup.change(turned(state.setup.now(), Axis::y, 5));
    open(state, folder / "none.toml");
    CHECK(state.file_error.find("none.toml") != std::string::npos);
    CHECK(state.file == folder / "a.toml");
    CHECK(state.pinned == Pixel{1, 1});
    CHECK(state.setup.can_undo());
    open(state, folder / "b.toml");
    CHECK(state.file_error == "");
    CHECK(state.scene->title == "other");
    CHECK_FALSE(state.pinned);
    CHECK_FALSE(state.setup.can_undo());
    CHECK_FALSE(state.appearance.dark);
    CHECK(state.page == Page::controls);
    CHECK(state.side_width == .6f);
    CHECK(state.scene_menu.folder == folder.path);
}

TEST_CASE("a scene that says with what it fails is set up so at a click, and undo takes it back") {
    const Folder folder;
    const auto file = folder / "s.toml";
    write(file, small + "[failing]\nscalar = 'float'\ntriangle = 'tolerance:2'\n");
    ViewerState state = opened(file);
    CHECK(can_show_failing(state));
    show_failing(state);
    CHECK(state.setup.now().options.scalar == Scalar::float_);
    CHECK(state.setup.now().options.triangle_rule == TriangleRule(Tolerance{2}));
    CHECK(state.overlay.measurement == "verdict");
    CHECK_FALSE(can_show_failing(state));
    state.setup.undo();
    CHECK(state.setup.now() == setup_of(*state.scene));
    CHECK(can_show_failing(state));

    // A choice that was made stays.
    state.setup.change(turned(state.setup.now(), Axis::z, 10));
    show_failing(state);
    CHECK(state.setup.now().options.turns.size() == 1);

    write(file, small);
    CHECK_FALSE(can_show_failing(opened(file)));
    write(file, small + "[failing]\nscalar = 'flaot'\n");
    CHECK_THROWS_WITH(
        opened(file),
        ((folder / "s.toml").string() + ":6:10: error: scalar: 'flaot' is not known; did you mean 'float'?").c_str());
}

TEST_CASE("undo keeps what is pinned") {
    const Folder folder;
    write(folder / "s.toml", small);
    ViewerState state = opened(folder / "s.toml");
    state.setup.change(turned(state.setup.now(), Axis::z, 10));
    state.pinned = Pixel{2, 2};
    state.overlay.measurement = "depth";
    state.setup.undo();
    CHECK(state.setup.now().options.turns.empty());
    CHECK(state.pinned == Pixel{2, 2});
    CHECK(state.overlay.measurement == "depth");
}

TEST_CASE("the paper's figures: its coefficients, model and sphere rule, whatever was changed before") {
    Setup setup;
    setup.shading.exponent = 3;
    setup.light_intensity = 0.5;
    setup.options.stage = 2;
    const Setup diffuse = with_figure(setup, figures[1]);
    // Design and paper: (0, 1, 0), exponent 15, a warm pink and white, intensity 1; shading begins with stage 4.
    const Shading<double> expected{ShadingModel::levental_2014, 0, 1, 0, 15, {255, 102, 102}, {255, 255, 255}};
    CHECK(diffuse.shading == expected);
    CHECK(diffuse.light_intensity == 1);
    CHECK(diffuse.options.sphere_rule == SphereRule(Levental2014{}));  // its figures need its faults
    CHECK(diffuse.options.stage == 4);
    CHECK(with_figure(diffuse, figures[1]) == diffuse);
    setup.options.stage = 5;
    CHECK(with_figure(setup, figures[1]).options.stage == 5);
}

TEST_CASE("turns in words") {
    CHECK(turns_in_words({}) == "none");
    std::vector<Turn<double>> turns(36, {Axis::z, 10});
    CHECK(turns_in_words(turns) == "z 10° × 36");
    turns.assign({{Axis::z, 10}, {Axis::y, -20.5}, {Axis::z, 10}});
    CHECK(turns_in_words(turns) == "z 10°, y −20.5°, z 10°");
}

TEST_CASE("where a vector points") {
    // (3, 3, 3√2): azimuth 45°, as high as it is long on the ground, length √(9 + 9 + 18) = 6.
    const Pointing p = pointing({3, 3, 3 * std::sqrt(2.0)});
    CHECK(p.azimuth == doctest::Approx(45));
    CHECK(p.elevation == doctest::Approx(45));
    CHECK(p.distance == doctest::Approx(6));
    const Vec3<double> back = vector_of(p);
    CHECK(back.x == doctest::Approx(3));
    CHECK(back.z == doctest::Approx(3 * std::sqrt(2.0)));
    CHECK(vector_of({90, 0, 2}) == Vec3<double>{0, 2, 0});  // quarter turns are exact
}

TEST_CASE(
    "the files of a scene's meshes are known, and a mesh that changes or goes is noticed when the scene is read "
    "again") {
    const Folder folder;
    const auto file = folder / "s.toml", obj = folder / "m.obj";
    write(obj, "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    write(file, small + "[[mesh]]\nfile = 'm.obj'\n[[mesh]]\nfile = 'm.obj'\n");
    ViewerState state = opened(file);
    CHECK(mesh_files(*state.scene) == std::vector{obj});  // twice in the scene, one file
    write(obj, "v 0 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\nf 1 2 4\n");
    reload(state);
    CHECK(state.scene->meshes.front()->faces.size() == 2);
    std::filesystem::remove(obj);
    reload(state);
    CHECK(state.file_error.find("m.obj") != std::string::npos);
    CHECK(state.scene->meshes.front()->faces.size() == 2);  // the last good scene
    CHECK(mesh_files(*state.scene) == std::vector{obj});    // so that it is noticed when it comes back
}

TEST_CASE("a slider of turns sets the last turn anew, or begins one about another axis") {
    const Folder folder;
    write(folder / "s.toml", small);
    const Setup none = opened(folder / "s.toml").setup.now();
    const auto turns = [](const Setup& setup) { return setup.options.turns; };
    using Turns = std::vector<Turn<double>>;
    CHECK(last_turn(none, Axis::z) == 0);
    const Setup z10 = with_last_turn(none, Axis::z, 10);
    CHECK(turns(z10) == Turns{{Axis::z, 10}});
    CHECK(last_turn(z10, Axis::z) == 10);
    CHECK(last_turn(z10, Axis::y) == 0);
    CHECK(turns(with_last_turn(z10, Axis::z, -35)) == Turns{{Axis::z, -35}});
    CHECK(turns(with_last_turn(z10, Axis::y, 5)) == Turns{{Axis::z, 10}, {Axis::y, 5}});
    CHECK(turns(with_last_turn(z10, Axis::z, 0)).empty());
    CHECK(turns(with_last_turn(z10, Axis::y, 0)) == Turns{{Axis::z, 10}});
}

TEST_CASE("the tour has seven stops, can go back, and can be left") {
    const Folder folder;
    write(folder / "s.toml", small);
    ViewerState state = opened(folder / "s.toml");
    REQUIRE(tour().size() == 7);
    state.space_shown = false;
    begin_tour(state);
    std::vector<WindowPart> parts;
    while (state.tour) {
        parts.push_back(tour()[*state.tour].part);
        if (tour()[*state.tour].page) CHECK(state.page == *tour()[*state.tour].page);
        go_on_tour(state);
    }
    CHECK(parts.size() == 7);
    CHECK(state.space_shown);  // one of its stops
    begin_tour(state);
    go_back_on_tour(state);
    CHECK(state.tour == 0u);
    go_on_tour(state);
    go_on_tour(state);
    go_back_on_tour(state);
    CHECK(state.tour == 1u);
    obey({Key::escape, 0, false, false}, state, {});
    CHECK_FALSE(state.tour);
}

TEST_CASE("what the mouse does, keys do: pin, look from elsewhere, change pages and the window's parts") {
    const Folder folder;
    write(folder / "s.toml", small);
    ViewerState state = opened(folder / "s.toml");
    const auto press = [&](Key key, bool control = false, bool shift = false) {
        obey({key, 0, control, shift}, state, {});
    };
    // 20 × 10 pixels at 30 screen pixels each; the middle of the area, (300, 150), lies on pixel (10, 5).
    state.area = {600, 300};
    state.view = {30, {0, 0}};
    press(Key::enter);
    CHECK(state.pinned == Pixel{10, 5});
    press(Key::enter, false, true);
    press(Key::left);
    CHECK(state.compared == Pixel{10, 5});
    CHECK(state.pinned == Pixel{9, 5});
    const Orbit before = state.orbit;
    press(Key::right, true);
    CHECK(state.orbit.azimuth == before.azimuth + 10);
    for (int i = 0; i < 20; ++i) press(Key::up, true);
    CHECK(state.orbit.elevation == 89);
    press(Key::home, true);
    CHECK(state.orbit == Orbit{});
    obey({Key::character, U'3', true, false}, state, {});
    CHECK(state.page == Page::overlay);
    const float side = state.side_width;
    press(Key::left, true, true);
    CHECK(state.side_width == doctest::Approx(side + .05));
    // While keys work buttons, these are Dear ImGui's; F6 and Esc come back.
    press(Key::f6);
    CHECK(state.keys_work_buttons);
    press(Key::left);
    CHECK(state.pinned == Pixel{9, 5});
    press(Key::escape);
    CHECK_FALSE(state.keys_work_buttons);
    CHECK(state.pinned);
}

TEST_CASE("at first the pixel nearest to the middle that shows something is pinned, once") {
    const Folder folder;
    write(folder / "s.toml", small);
    ViewerState state = opened(folder / "s.toml");
    auto image = std::make_shared<Image>(20, 10);
    // Twice the middle is (20, 10) in pixel corners: (5, 4) is 2·5 + 1 − 20 = −9 and −1 away, (16, 4) 13 and −1, and
    // (10, 0) is on the border.
    for (const Pixel lit : {Pixel{5, 4}, Pixel{16, 4}, Pixel{10, 0}}) image->at(lit.x, lit.y) = {9, 9, 9};
    Results results;
    results.picture = {image, 1};
    pin_at_first(state, results);
    CHECK_FALSE(state.pinned);  // nobody asked
    state.pins_at_first = true;
    results.busy = true;
    pin_at_first(state, results);
    CHECK_FALSE(state.pinned);  // the picture is not whole yet
    results.busy = false;
    pin_at_first(state, results);
    CHECK(state.pinned == Pixel{5, 4});
    pin(state, std::nullopt);
    pin_at_first(state, results);
    CHECK_FALSE(state.pinned);
}
