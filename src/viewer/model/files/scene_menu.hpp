#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/model/files/file_version.hpp"
#include "viewer/platform/input.hpp"

namespace glassbox {

struct ViewerState;

/// A row of the window *Open a scene*: a scene file, or a folder to look into.
struct SceneRow {
    std::string section;  ///< what it stands under
    std::filesystem::path path;
    std::string name;  ///< as it is shown: "room", "lessons/", "../"
    bool is_folder = false;
    FileVersion version{};  ///< of a scene file, when it was listed
};

/// The scenes that can be opened instead.
struct SceneMenu {
    bool shown = false;
    std::filesystem::path folder;               ///< of the scenes that come with Glassbox; empty: not there
    std::filesystem::path browsed = ".";        ///< the folder whose scenes are listed, too
    std::vector<std::filesystem::path> recent;  ///< opened before, the newest first
    std::string typed;                          ///< a path, or part of a name; see type
    std::vector<SceneRow> listed;               ///< all that there are, as last looked for
    std::size_t chosen = 0;                     ///< a row of `rows`
    int renewed = 0;                            ///< how often `typed` was set by something else than typing
};

inline constexpr std::size_t most_recent = 10;

/// Shows the window, with what is on the disk now; closes what else takes the keyboard.
void show_scene_menu(ViewerState& state);

/// Lists all that can be opened: recent files, the browsed folder, what comes with Glassbox.
void list_scenes(SceneMenu& menu);

/// What is listed for what is typed: after a last slash, what begins like that in the folder before it; without one,
/// whatever has it in its name, in either case.
std::vector<SceneRow> rows(const SceneMenu& menu);

/// Sets what is typed; reads the folder that it names, if that is another one than before.
void type(SceneMenu& menu, const std::string& typed);

/// What Tab makes of what is typed: as much more as all rows that go on like it have in common.
std::string completed(const SceneMenu& menu);

/// Opens the chosen row: looks into a folder, or opens a scene and closes the window. Without a row, opens what is
/// typed, and `file_error` says why it cannot.
void open_chosen(ViewerState& state);

/// Opens a scene as a user does, by a file or by the name of one that comes with Glassbox: it becomes the most recent
/// one, and the window closes. On an error `file_error` says why.
void open_scene(ViewerState& state, const std::filesystem::path& file);

/// Opens the first scene of the files that were dropped on the window; says what can be dropped if there is none.
void open_dropped(ViewerState& state, const std::vector<std::string>& files);

/// Makes a file the most recent one.
void remember_recent(SceneMenu& menu, const std::filesystem::path& file);

/// What a key does while the window is shown.
void obey_in_scene_menu(const KeyPress& press, ViewerState& state);

}  // namespace glassbox
