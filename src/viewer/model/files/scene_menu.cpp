#include "viewer/model/files/scene_menu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "scene/error.hpp"
#include "scene/scene_path.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

namespace fs = std::filesystem;

namespace {

std::string in_lower_case_latin(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool is_scene_file(const fs::path& file) { return in_lower_case_latin(file.extension().string()) == ".toml"; }

/// The folder of a path that is being typed, and what of a name follows it.
struct Typed {
    std::string folder, name;  ///< the folder with its last slash; empty: none is typed
};

Typed parts_of(const std::string& typed) {
    const std::size_t slash = typed.rfind('/');
    if (slash == std::string::npos) return {"", typed};
    return {typed.substr(0, slash + 1), typed.substr(slash + 1)};
}

SceneRow scene_row(std::string section, const fs::path& file, std::string name) {
    return {std::move(section), file, std::move(name), false, file_version(file)};
}

/// A folder's own folders and scenes, by name; hidden ones are left out.
std::vector<SceneRow> rows_of_folder(const fs::path& folder, const std::string& section) {
    std::vector<SceneRow> folders, scenes;
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; entry != end; entry.increment(none)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        if (entry->is_directory(none)) folders.push_back({section, entry->path(), name + '/', true});
        else if (is_scene_file(name)) scenes.push_back(scene_row(section, entry->path(), name));
    }
    const auto by_name = [](const SceneRow& a, const SceneRow& b) { return a.name < b.name; };
    std::sort(folders.begin(), folders.end(), by_name);
    std::sort(scenes.begin(), scenes.end(), by_name);
    folders.insert(folders.end(), scenes.begin(), scenes.end());
    return folders;
}

fs::path as_absolute(const fs::path& path) {
    std::error_code none;
    const fs::path whole = fs::absolute(path, none).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

/// The same file by the name that is shorter to type from here: relative, if it lies in the current folder.
fs::path from_here(const fs::path& file) {
    std::error_code none;
    const fs::path relative = as_absolute(file).lexically_relative(fs::current_path(none));
    return relative.empty() || *relative.begin() == ".." ? as_absolute(file) : relative;
}

/// Where what is typed is, seen from the folder that is browsed; ~/ is the home folder.
fs::path place_of(const SceneMenu& menu, const std::string& typed) {
    const char* const home = std::getenv("HOME");
    return home && typed.starts_with("~/") ? fs::path(home) / typed.substr(2) : menu.browsed / typed;
}

fs::path typed_folder(const SceneMenu& menu) { return place_of(menu, parts_of(menu.typed).folder); }

void browse(SceneMenu& menu, const fs::path& folder) {
    menu.browsed = as_absolute(folder);
    menu.typed.clear();
    ++menu.renewed;
    list_scenes(menu);
    const auto scene =
        std::find_if(menu.listed.begin(), menu.listed.end(), [](const SceneRow& r) { return !r.is_folder; });
    menu.chosen = scene == menu.listed.end() ? 0 : static_cast<std::size_t>(scene - menu.listed.begin());
}

void move_choice(SceneMenu& menu, int by) {
    const int most = static_cast<int>(rows(menu).size()) - 1;
    menu.chosen = static_cast<std::size_t>(std::clamp(static_cast<int>(menu.chosen) + by, 0, std::max(0, most)));
}

}  // namespace

void show_scene_menu(ViewerState& state) {
    state.save_menu.shown = state.copy_menu.shown = state.keys_shown = false;
    SceneMenu& menu = state.scene_menu;
    menu.shown = true;
    browse(menu, menu.browsed);
    const auto is_scene = [&](std::size_t i) { return i < menu.listed.size() && !menu.listed[i].is_folder; };
    const bool is_open = is_scene(menu.chosen) && menu.listed[menu.chosen].path == as_absolute(state.file);
    if (is_open && is_scene(menu.chosen + 1)) ++menu.chosen;  // rather another one
}

void list_scenes(SceneMenu& menu) {
    menu.listed.clear();
    if (!parts_of(menu.typed).folder.empty()) {
        menu.listed = rows_of_folder(typed_folder(menu), "In " + typed_folder(menu).lexically_normal().string());
        return;
    }
    std::error_code none;
    for (const fs::path& file : menu.recent)
        if (fs::is_regular_file(file, none))
            menu.listed.push_back(scene_row("Opened before", file, scene_word(from_here(file))));
    const fs::path here = as_absolute(menu.browsed);
    const std::string section = "In " + here.string();
    if (here.has_relative_path()) menu.listed.push_back({section, here.parent_path(), "../", true});
    const auto add = [&](const std::vector<SceneRow>& more) {
        menu.listed.insert(menu.listed.end(), more.begin(), more.end());
    };
    add(rows_of_folder(here, section));
    if (menu.folder.empty() || fs::equivalent(menu.folder, here, none)) return;
    std::vector<SceneRow> shipped = rows_of_folder(menu.folder, "With Glassbox come");
    std::erase_if(shipped, [](const SceneRow& row) { return row.is_folder; });
    for (SceneRow& row : shipped) row.name = row.path.stem().string();
    add(shipped);
}

std::vector<SceneRow> rows(const SceneMenu& menu) {
    const auto [folder, name] = parts_of(menu.typed);
    const std::string wanted = in_lower_case_latin(name);
    std::vector<SceneRow> matching;
    for (const SceneRow& row : menu.listed) {
        const std::size_t at = in_lower_case_latin(row.name).find(wanted);
        if (folder.empty() ? at != std::string::npos : at == 0) matching.push_back(row);
    }
    return matching;
}

void type(SceneMenu& menu, const std::string& typed) {
    if (typed == menu.typed) return;
    const bool is_elsewhere = parts_of(typed).folder != parts_of(menu.typed).folder;
    menu.typed = typed;
    menu.chosen = 0;
    if (is_elsewhere) list_scenes(menu);
}

std::string completed(const SceneMenu& menu) {
    const auto [folder, name] = parts_of(menu.typed);
    std::string common;
    bool is_first = true;
    for (const SceneRow& row : rows(menu)) {
        if (!row.name.starts_with(name) || row.name == "../") continue;
        if (std::exchange(is_first, false)) common = row.name;
        const auto differs = std::mismatch(common.begin(), common.end(), row.name.begin(), row.name.end()).first;
        common.erase(differs, common.end());
    }
    return is_first ? menu.typed : folder + common;
}

void open_scene(ViewerState& state, const fs::path& file) {
    open(state, file);
    if (!state.file_error.empty()) return;
    remember_recent(state.scene_menu, state.file);
    state.scene_menu.shown = false;
    state.pins_at_first = true;
}

void open_chosen(ViewerState& state) {
    const SceneMenu& menu = state.scene_menu;
    const std::vector<SceneRow> listed = rows(menu);
    if (menu.chosen < listed.size()) {
        const SceneRow& row = listed[menu.chosen];
        if (row.is_folder) return browse(state.scene_menu, row.path);
        return open_scene(state, from_here(row.path));
    }
    try {
        const fs::path typed = place_of(menu, menu.typed);
        std::error_code none;
        open_scene(state, fs::exists(typed, none) ? from_here(typed) : scene_path(menu.typed));
    } catch (const Error& error) {
        state.file_error = error.what();
    }
}

void open_dropped(ViewerState& state, const std::vector<std::string>& files) {
    const auto scene = std::find_if(files.begin(), files.end(), [](const std::string& f) { return is_scene_file(f); });
    if (scene != files.end()) return open_scene(state, from_here(*scene));
    if (files.empty()) return;
    const fs::path first(files.front());
    const bool is_mesh = in_lower_case_latin(first.extension().string()) == ".obj";
    state.notice =
        refused(is_mesh ? fmt::format("{} is a mesh, and a scene says how it is seen: write file = \"{}\" under "
                                      "[[mesh]] in a scene (.toml), and drop that",
                                      first.filename().string(), first.filename().string())
                        : fmt::format("{} is no scene: drop a scene file, .toml", first.filename().string()));
}

void remember_recent(SceneMenu& menu, const fs::path& file) {
    const fs::path whole = as_absolute(file);
    std::erase(menu.recent, whole);
    menu.recent.insert(menu.recent.begin(), whole);
    if (menu.recent.size() > most_recent) menu.recent.resize(most_recent);
}

void obey_in_scene_menu(const KeyPress& press, ViewerState& state) {
    constexpr int page = 5;
    SceneMenu& menu = state.scene_menu;
    switch (press.key) {
        case Key::escape:
            menu.shown = false;
            return;
        case Key::enter:
            return open_chosen(state);
        case Key::up:
            return move_choice(menu, -1);
        case Key::down:
            return move_choice(menu, 1);
        case Key::page_up:
            return move_choice(menu, -page);
        case Key::page_down:
            return move_choice(menu, page);
        default:
            return;
    }
}

}  // namespace glassbox
