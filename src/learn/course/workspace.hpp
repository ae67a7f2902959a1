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
    /// The folders of lessons, by the lesson's name, that are not called as their lesson is.
    std::map<std::string, std::filesystem::path> called_otherwise = {};

    /// Where `learn` makes what it makes for itself, if not in the learner's folder.
    std::filesystem::path hidden_elsewhere = {};

    /// What `learn` makes for itself.
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
};

/// The workspace of a program that runs in `here`: the project is the next folder above that has lessons, or else the
/// one that this program was built from, or what was installed with it. `folder` is the learner's; empty for the usual
/// one. Throws Error.
Workspace open_workspace(const std::filesystem::path& here, const std::filesystem::path& folder = {});

/// The exercise that is called "2", "2-spheres" or "spheres". Throws Error, which says what there is.
const Exercise& exercise_called(const Workspace& workspace, std::string_view name);

/// Makes a folder, and those that it lies in, unless it is there; returns it. Throws Error.
std::filesystem::path make_folder(const std::filesystem::path& folder);

/// The same, with nothing in it.
std::filesystem::path new_folder(const std::filesystem::path& folder);

/// Throws Error if nothing more can be written in a folder: the disk is full, say. To be asked when a program could not
/// do its work there, and that may be why.
void check_room(const std::filesystem::path& folder);

/// Makes the learner's headers of a lesson from the starters, unless its folder is there. Returns whether it made it.
bool make_starters(const Workspace& workspace, const Exercise& exercise);

/// Puts a new text in the place of a learner's header; what was there is kept as NAME.hpp.1, or the next number that is
/// free. Returns where it is kept; empty if there was nothing, or the same text.
std::filesystem::path replace_header(const Workspace& workspace, const Exercise& exercise, const std::string& header,
                                     const std::string& text);

/// Puts the starters back in the place of the learner's headers; returns what is kept, and where.
std::vector<std::filesystem::path> reset(const Workspace& workspace, const Exercise& exercise);

/// The text of a learner's header. Throws Error if it is not there, or is no text file, and says how to get one.
std::string read_header(const Workspace& workspace, const Exercise& exercise, const std::string& header);

/// A path as it is to be shown: from the folder where the program runs, if it lies in it.
std::string shown(const std::filesystem::path& path);

}  // namespace glassbox::learn
