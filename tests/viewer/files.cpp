// Opening, saving and copying: what the windows list, what keys and typed letters do in them, what is written.
#include <doctest.h>

#include <algorithm>
#include <fstream>
#include <stop_token>

#include "../output/folder.hpp"
#include "render/job.hpp"
#include "scene/error.hpp"
#include "viewer/hidden_viewer.hpp"
#include "viewer/model/files/thumbnail.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/state/keys.hpp"
#include "viewer/model/state/settings.hpp"

using namespace glassbox;
using test::Folder;

namespace {

namespace fs = std::filesystem;

const std::string small = "title = 'small'\n[image]\nwidth = 20\nheight = 10\n";

void write_file(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

/// A folder in which the test runs: two scenes, a mesh, a hidden file, a folder with a third scene.
struct Workplace : Folder {
    fs::path before = fs::current_path();

    Workplace() {
        fs::create_directory(*this / "deep");
        for (const char* name : {"b.toml", "a.toml", "deep/bcd.toml", "deep/bce.toml", ".hidden.toml"})
            write_file(*this / name, small);
        write_file(*this / "mesh.obj", "");
        fs::current_path(path);
    }
    ~Workplace() { fs::current_path(before); }
};

std::vector<std::string> names(const SceneMenu& menu) {
    std::vector<std::string> all;
    for (const SceneRow& row : rows(menu)) all.push_back(row.name);
    return all;
}

using Names = std::vector<std::string>;

constexpr KeyPress letter(char32_t c) { return {Key::character, c, false, false}; }
constexpr KeyPress named(Key key) { return {key, 0, false, false}; }

void press(HiddenViewer& viewer, const KeyPress& key) {
    viewer.frame({}, {&key, 1});
    viewer.settle();
}

}  // namespace

TEST_CASE("what can be opened: recent files that are there, the folder here, what comes with Glassbox") {
    const Workplace here;
    const Folder shipped;
    write_file(shipped / "room.toml", small);
    ViewerState state = opened("a.toml");
    state.scene_menu.folder = shipped.path;
    state.scene_menu.recent = {here / "deep/bcd.toml", here / "gone.toml"};
    show_scene_menu(state);
    SceneMenu& menu = state.scene_menu;
    CHECK(names(menu) == Names{"deep/bcd.toml", "../", "deep/", "a.toml", "b.toml", "room"});
    CHECK(menu.chosen == 0);
    CHECK(rows(menu)[0].section == "Opened before");
    CHECK(rows(menu)[0].version != FileVersion{});

    // Without a slash whatever has it in its name; with one, what begins like it in that folder.
    type(menu, "B");
    CHECK(names(menu) == Names{"deep/bcd.toml", "b.toml"});
    type(menu, "deep/");
    CHECK(names(menu) == Names{"bcd.toml", "bce.toml"});
    CHECK(completed(menu) == "deep/bc");
    type(menu, "deep/bcd");
    CHECK(names(menu) == Names{"bcd.toml"});
    CHECK(completed(menu) == "deep/bcd.toml");
    type(menu, "deep/x");
    CHECK(names(menu).empty());
    CHECK(completed(menu) == "deep/x");
    type(menu, "d");
    CHECK(completed(menu) == "deep/");  // not the recent deep/bcd.toml alone: both go on like this
    type(menu, "");
    CHECK(names(menu).size() == 6);
}

TEST_CASE("keys choose a row, look into folders, open a scene, and close") {
    const Workplace here;
    ViewerState state = opened("a.toml");
    const Results results;
    const auto key = [&](Key which) { obey(named(which), state, results); };
    show_scene_menu(state);
    CHECK(takes_keyboard(state));
    CHECK(rows(state.scene_menu)[state.scene_menu.chosen].name == "b.toml");  // another one than that which is open
    key(Key::up);
    key(Key::up);  // deep/
    key(Key::enter);
    CHECK(names(state.scene_menu) == Names{"../", "bcd.toml", "bce.toml"});
    CHECK(rows(state.scene_menu)[state.scene_menu.chosen].name == "bcd.toml");
    key(Key::down);
    key(Key::down);  // there is no more
    key(Key::enter);
    CHECK(state.file == fs::path("deep/bce.toml"));
    CHECK_FALSE(state.scene_menu.shown);
    CHECK(state.scene_menu.recent == std::vector<fs::path>{here / "deep/bce.toml"});

    show_scene_menu(state);
    obey(letter('d'), state, results);  // a letter that is typed does not turn the view
    CHECK(state.setup.now().options.turns.empty());
    key(Key::escape);
    CHECK_FALSE(state.scene_menu.shown);

    show_scene_menu(state);
    type(state.scene_menu, "nothing-like-this");
    key(Key::enter);
    CHECK(state.file_error.find("there is no such file") != std::string::npos);
    CHECK(state.scene_menu.shown);
    CHECK(state.file == fs::path("deep/bce.toml"));
}

TEST_CASE("recent files: the newest first, each once, at most ten; settings keep them") {
    SceneMenu menu;
    for (int i = 0; i < 12; ++i) remember_recent(menu, fs::path("/s") / std::to_string(i));
    remember_recent(menu, "/s/5");
    REQUIRE(menu.recent.size() == 10);
    CHECK(menu.recent[0] == "/s/5");
    CHECK(menu.recent[1] == "/s/11");
    CHECK(std::count(menu.recent.begin(), menu.recent.end(), fs::path("/s/5")) == 1);

    const Folder folder;
    Settings settings;
    settings.recent = menu.recent;
    write_settings(folder / "viewer.json", settings);
    CHECK(read_settings(folder / "viewer.json") == settings);
    write_file(folder / "viewer.json", R"({"recent": ["/a", 3, "relative", null, "/b"], "dark": false})");
    CHECK(read_settings(folder / "viewer.json").recent == std::vector<fs::path>{"/a", "/b"});
    write_file(folder / "viewer.json", R"({"recent": "/a"})");
    CHECK(read_settings(folder / "viewer.json").recent.empty());
    settings.recent = {"/not-utf8-\xe9"};
    write_settings(folder / "viewer.json", settings);  // does not fail
    CHECK(read_settings(folder / "viewer.json").recent.size() == 1);
}

TEST_CASE("files that are dropped: the first scene opens; else it is said what can be dropped") {
    const Workplace here;
    ViewerState state = opened("a.toml");
    open_dropped(state, {(here / "mesh.obj").string(), (here / "b.toml").string(), (here / "a.toml").string()});
    CHECK(state.file == fs::path("b.toml"));
    CHECK(state.notice.text.empty());
    open_dropped(state, {(here / "mesh.obj").string()});
    CHECK(state.notice.is_error);
    CHECK(state.notice.text.find("file = \"mesh.obj\" under [[mesh]]") != std::string::npos);
    open_dropped(state, {"/pictures/cat.jpg"});
    CHECK(state.notice.text == "cat.jpg is no scene: drop a scene file, .toml");
    CHECK(state.file == fs::path("b.toml"));
}

TEST_CASE("small pictures: at most 96 by 72, in the picture's shape; of a file that is no scene, why") {
    const Folder folder;
    write_file(folder / "wide.toml", "title = 'w'\n[image]\nwidth = 960\nheight = 100\n");
    write_file(folder / "tiny.toml", "[image]\nwidth = 3\nheight = 2\n");
    write_file(folder / "bad.toml", "[image\n");
    const Thumbnail wide = thumbnail(folder / "wide.toml", {}, {});
    REQUIRE(wide.image);
    CHECK(wide.title == "w");
    CHECK(wide.image->width == 96);
    CHECK(wide.image->height == 10);
    CHECK(thumbnail(folder / "tiny.toml", {}, {}).image->width == 3);
    const Thumbnail bad = thumbnail(folder / "bad.toml", {}, {});
    CHECK_FALSE(bad.image);
    CHECK(bad.error.find("bad.toml:1") != std::string::npos);
}

TEST_CASE("what can be saved follows what is seen, and names are free ones") {
    const Workplace here;
    ViewerState state = opened("a.toml");
    CHECK(save_choices(state).size() == 1);
    show_save_menu(state);
    CHECK(state.save_menu.typed == "a.png");
    state.overlay.measurement = "depth";
    state.beside = Beside::other;
    write_file(here / "a-depth.png", "");
    show_save_menu(state);
    REQUIRE(save_choices(state).size() == 4);
    CHECK(state.save_menu.what == SaveWhat::overlay);
    CHECK(state.save_menu.typed == "a-depth-2.png");
    const Results results;
    const auto key = [&](Key which) { obey(named(which), state, results); };
    key(Key::down);
    CHECK(state.save_menu.typed == "a-depth.csv");
    key(Key::down);
    CHECK(state.save_menu.typed == "a-beside.png");
    key(Key::down);
    CHECK(state.save_menu.what == SaveWhat::beside);
    for (int i = 0; i < 5; ++i) key(Key::up);
    CHECK(state.save_menu.what == SaveWhat::picture);
}

TEST_CASE("a file that is there is replaced only when asked for twice, and nothing is written where that cannot be") {
    const Workplace here;
    ViewerState state = opened("a.toml");
    const Results results;
    show_save_menu(state);
    type(state.save_menu, "taken");
    write_file(here / "taken.png", "mine");
    save(state, results);
    CHECK(state.save_menu.asked == "taken.png");  // .png is added where no extension is typed
    CHECK_FALSE(state.saving);
    type(state.save_menu, "other.png");
    CHECK(state.save_menu.asked.empty());
    type(state.save_menu, "taken.png");
    save(state, results);
    CHECK_FALSE(state.saving);
    save(state, results);
    REQUIRE(state.saving);
    CHECK(state.saving->file == here / "taken.png");
    CHECK(state.saving->command == "glassbox render a.toml -o a.png");
    CHECK_FALSE(state.save_menu.shown);
    CHECK(test::content(here / "taken.png") == "mine");

    state.saving.reset();
    show_save_menu(state);
    for (const auto& [typed, part] : {std::pair{"p.gif", "use .png or .ppm"},
                                      {"none/p.png", "create the folder"},
                                      {"", "name a file"},
                                      {"deep/", "name a file"}}) {
        type(state.save_menu, typed);
        save(state, results);
        CHECK_MESSAGE(state.save_menu.error.find(part) != std::string::npos, state.save_menu.error);
        CHECK_FALSE(state.saving);
        CHECK(state.save_menu.shown);
    }
}

TEST_CASE("commands of what is seen") {
    const Workplace here;
    ViewerState state = opened("a.toml");
    CHECK(copy_rows(state).size() == 2);
    Setup setup = state.setup.now();
    setup.options.scalar = Scalar::float_;
    state.setup.change(turned(setup, Axis::z, 10));
    state.overlay.measurement = "n.l";
    pin(state, Pixel{3, 4});
    CHECK(command_to_view(state) == "glassbox view a.toml --turn z:10 --scalar float --pixel 3,4 --overlay n.l");
    CHECK(command_to_render(state, ".png") == "glassbox render a.toml --turn z:10 --scalar float -o a.png");
    CHECK(command_to_measure(state, ".exr") ==
          "glassbox measure a.toml --turn z:10 --scalar float --what n.l -o a-n.l.exr");
    CHECK(copy_rows(state).size() == 4);

    const Results results;
    obey({Key::character, 'c', true, false}, state, results);
    CHECK(state.to_copy == command_to_view(state));
    CHECK(state.notice.text == "copied: " + command_to_view(state));
    obey({Key::character, 'c', true, true}, state, results);
    CHECK(state.copy_menu.shown);
    obey(named(Key::down), state, results);
    obey(named(Key::enter), state, results);
    CHECK(state.to_copy == command_to_render(state, ".png"));
    CHECK_FALSE(state.copy_menu.shown);
    copy(state, "a long story", "the story of pixel (3, 4), as text");
    CHECK(state.notice.text == "copied: the story of pixel (3, 4), as text");
}

TEST_CASE("a scene that comes with Glassbox goes by its name in a command, unless a file here has it") {
    const Folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    ViewerState state = opened(fs::path(SCENES) / "triangle.toml");
    CHECK(command_to_view(state) == "glassbox view triangle");
    write_file("triangle", "");
    CHECK(command_to_view(state) == "glassbox view " + (fs::path(SCENES) / "triangle.toml").string());
    fs::current_path(before);
}

TEST_CASE("a notice goes by itself") {
    const Notice told = done("saved");
    CHECK(later(told, 1).text == "saved");
    CHECK(later(told, 6).text.empty());
    CHECK(refused("no").seconds > told.seconds);
}

TEST_CASE("in the window: what is typed goes into the field, and what is saved is written in the background") {
    const Workplace here;
    HiddenViewer viewer(opened("a.toml"), {1024, 640});
    viewer.settle();
    press(viewer, {Key::character, 'o', true, false});
    for (const char32_t c : U"bc")
        if (c != 0) press(viewer, letter(c));
    CHECK(viewer.state().scene_menu.typed == "bc");
    CHECK(viewer.state().setup.now().options.turns.empty());
    press(viewer, named(Key::escape));
    CHECK_FALSE(viewer.state().scene_menu.shown);

    press(viewer, {Key::character, 'o', true, false});
    for (const char32_t c : U"b.")
        if (c != 0) press(viewer, letter(c));
    press(viewer, named(Key::enter));
    CHECK(viewer.state().file == fs::path("b.toml"));

    press(viewer, {Key::character, 's', true, false});
    press(viewer, named(Key::enter));
    CHECK(fs::exists("b.png"));
    CHECK(viewer.state().notice.text == "saved: " + (here / "b.png").string());
    press(viewer, {Key::character, 'd', false, false});  // the keyboard is the picture's again
    CHECK(viewer.state().setup.now().options.turns.size() == 1);
    CHECK(viewer.screen().complaints() == 0);
}
