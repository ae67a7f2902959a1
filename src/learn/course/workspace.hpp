#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "learn/course/exercise.hpp"

namespace glassbox::learn {

/// Where a learner works: the project, whose lessons and tests are used, and the folder of the learner's own headers.
struct Workspace {
    std::filesystem::path root;    ///< the project's root, absolute
    std::filesystem::path folder;  ///< the learner's folder, absolute
    /// The learner's folder by default: my/ in the project, or where the program runs if it is installed.
    std::filesystem::path usual_folder = {};
    std::string program = "./glassbox";  ///< how it is called
    std::vector<Exercise> exercises;
    /// The folders of lessons that are not named as their lesson is, by the lesson's name.
    std::map<std::string, std::filesystem::path> called_otherwise = {};

    /// Where `learn` puts the files that it makes for itself, if not in the learner's folder.
    std::filesystem::path hidden_elsewhere = {};

    /// The folder of the files that `learn` makes for itself.
    std::filesystem::path hidden() const { return hidden_elsewhere.empty() ? folder / ".glassbox" : hidden_elsewhere; }

    /// The folder with the learner's headers of a lesson; it goes on the include path.
    std::filesystem::path headers_of(const Exercise& exercise) const {
        const auto other = called_otherwise.find(exercise.name);
        return other == called_otherwise.end() ? folder / exercise.name : other->second;
    }

    std::filesystem::path header(const Exercise& exercise, const std::string& name) const {
        return headers_of(exercise) / name;
    }
    /// The folder with our headers of a lesson, and one of them.
    std::filesystem::path solutions_of(const Exercise& exercise) const { return root / exercise.core; }
    std::filesystem::path solution(const Exercise& exercise, const std::string& name) const {
        return solutions_of(exercise) / name;
    }
    /// The text of a header that a learner begins with. Throws Error.
    std::string starter(const Exercise& exercise, const std::string& name) const;
};

/// Returns the workspace of a program that runs in `here`: the project is the nearest folder above that has lessons, or
/// else the one that this program was built from, or what was installed with it. `folder` is the learner's; empty means
/// the usual one. Throws Error.
Workspace open_workspace(const std::filesystem::path& here, const std::filesystem::path& folder = {});

/// Returns the exercise that is called "2", "2-spheres" or "spheres". Throws Error, which lists those there are.
const Exercise& exercise_called(const Workspace& workspace, std::string_view name);

/// Makes a folder and its parents, unless it exists; returns it. Throws Error.
std::filesystem::path make_folder(const std::filesystem::path& folder);

/// The same, with nothing in it.
std::filesystem::path new_folder(const std::filesystem::path& folder);

/// Throws Error if nothing more can be written in a folder, for example because the disk is full. Call it when a
/// program could not do its work there and that may be why.
void check_room(const std::filesystem::path& folder);

/// Makes the learner's headers of a lesson from the starters, unless its folder exists. Returns whether it made them.
bool make_starters(const Workspace& workspace, const Exercise& exercise);

/// Throws Error, which says how to begin, if the learner has no headers of a lesson yet.
void check_begun(const Workspace& workspace, const Exercise& exercise);

/// Replaces the text of a learner's header; keeps the old file as NAME.hpp.1, or the next number that is free. Returns
/// where it is kept; empty if there was nothing, or the same text.
std::filesystem::path replace_header(const Workspace& workspace, const Exercise& exercise, const std::string& header,
                                     const std::string& text);

/// Replaces the learner's headers by the starters; returns what is kept, and where.
std::vector<std::filesystem::path> reset(const Workspace& workspace, const Exercise& exercise);

/// Returns the text of a learner's header. Throws Error, which says how to get one, if it is missing or not a text
/// file.
std::string read_header(const Workspace& workspace, const Exercise& exercise, const std::string& header);

/// Returns a path for display: relative to the folder where the program runs, if it lies in it.
std::string shown(const std::filesystem::path& path);

}  // namespace glassbox::learn
