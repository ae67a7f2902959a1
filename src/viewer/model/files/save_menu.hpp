#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "render/measure/measurements.hpp"
#include "render/measure/minus.hpp"
#include "render/setup.hpp"
#include "viewer/platform/input.hpp"

namespace glassbox {

struct Job;

struct ViewerState;
struct Results;

/// What can be saved of what is seen.
enum class SaveWhat {
    picture,
    overlay,  ///< with its legend
    numbers,  ///< that the overlay shows
    beside,   ///< what stands on the right of the split
};

/// What is to be written into a file, with all that it is made from.
struct Saving {
    std::filesystem::path file;
    std::string command;  ///< makes the same bytes; empty: none does
    std::shared_ptr<const Scene> scene{};
    Setup setup{};
    const Measurement* measured = nullptr;  ///< null: the picture is meant
    std::optional<Minus> minus{};           ///< is subtracted from what is measured
    std::shared_ptr<const Image> drawn{};   ///< what no command draws: a learner's picture, a difference
    int number = 0;                         ///< counts the files of this session

    bool operator==(const Saving&) const = default;
};

/// How a file's writing ended.
struct Saved {
    int number = 0;     ///< of the Saving
    std::string error;  ///< empty: it is there
};

/// The window *Save*.
struct SaveMenu {
    bool shown = false;
    SaveWhat what = SaveWhat::picture;
    std::string typed;  ///< the file's name
    std::string asked;  ///< the file that is there, and that the next Enter replaces; empty: nothing is asked
    std::string error;  ///< what is wrong with what is typed
    std::filesystem::path folder;  ///< where a name without a folder is written
    int renewed = 0;               ///< how often `typed` was set by something else than typing
};

/// What the state shows that can be saved.
struct SaveChoice {
    SaveWhat what;
    std::string label;
};
std::vector<SaveChoice> save_choices(const ViewerState& state);

/// Shows the window, with a name that is free in the current folder.
void show_save_menu(ViewerState& state);

/// Chooses what is to be saved, and names the file after it.
void choose(ViewerState& state, SaveWhat what);

void type(SaveMenu& menu, const std::string& typed);

/// What is to be written. Throws Error where that file cannot be written, has an extension that does not fit, or where
/// there is nothing of the kind, or not yet.
Saving saving(const ViewerState& state, const Results& results, SaveWhat what, const std::filesystem::path& file);

/// Asks for the file to be written, and closes the window; or says what is wrong; or asks whether to replace a file
/// that is there, once.
void save(ViewerState& state, const Results& results);

/// Computes and writes. Throws Error, Cancelled.
void write(const Saving& saving, const Job& job);

/// Tells how the last writing ended, once.
void follow_saved(ViewerState& state, const Results& results);

/// What a key does while the window is shown.
void obey_in_save_menu(const KeyPress& press, ViewerState& state, const Results& results);

}  // namespace glassbox
