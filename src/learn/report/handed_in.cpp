#include "learn/report/handed_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scene/error.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 4;                    // nested folders: an archive's, a name's, Glassbox's, my
constexpr std::size_t most_entries = 10'000;  // entries looked at: nobody hands in more by hand

std::string note(const fs::path& where, const std::string& what) {
    return fmt::format("{}: note: {}", shown(where), what);
}

/// "1_Rays" is "1-rays".
std::string plain_name(const fs::path& path) {
    std::string name = path.filename().string();
    for (char& c : name)
        c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name;
}

bool is_called(const fs::path& folder, const Exercise& exercise) {
    const std::string name = plain_name(folder);
    return name == exercise.name || name == exercise.name.substr(exercise.name.find('-') + 1) ||
           name == std::to_string(exercise.number);
}

/// Returns what is in a folder, in order, without hidden entries; nothing if it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> entries;
    std::error_code failed;
    fs::directory_iterator entry(folder, failed), end;
    for (; !failed && entry != end && entries.size() < most_entries; entry.increment(failed))
        if (!entry->path().filename().string().starts_with('.')) entries.push_back(entry->path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

std::vector<fs::path> folders_in(const fs::path& folder) {
    std::vector<fs::path> folders = entries_of(folder);
    std::erase_if(folders, [](const fs::path& path) {  // a link may lead to another learner's
        std::error_code none;
        return fs::is_symlink(path, none) || !fs::is_directory(path, none);
    });
    return folders;
}

/// Whether a folder has one of a lesson's headers where it belongs.
bool has_header_of(const fs::path& folder, const Exercise& exercise) {
    return std::ranges::any_of(exercise.headers, [&](const std::string& header) {
        std::error_code none;
        return fs::is_regular_file(folder / header, none);
    });
}

/// Returns the lesson's folder in a learner's: the one with exactly its name, or else the first with a similar name.
fs::path lesson_in(const fs::path& learner, const Exercise& exercise) {
    if (has_header_of(learner / exercise.name, exercise)) return learner / exercise.name;
    for (const fs::path& folder : folders_in(learner))
        if (is_called(folder, exercise) && has_header_of(folder, exercise)) return folder;
    return {};
}

bool has_lessons_begun(const fs::path& folder, const std::vector<Exercise>& exercises) {
    return std::ranges::any_of(exercises, [&](const Exercise& one) { return !lesson_in(folder, one).empty(); });
}

/// Returns the subfolders where a learner's may be: of all of Glassbox only my/, as the rest is ours.
std::vector<fs::path> next_level(const fs::path& folder) {
    std::error_code none;
    std::vector<fs::path> folders = folders_in(folder);
    if (fs::is_regular_file(folder / "lessons/1-rays/exercise.toml", none))
        std::erase_if(folders, [](const fs::path& one) { return one.filename() != "my"; });
    return folders;
}

/// Returns the folders that contain lessons' folders, on the first level where there are any.
std::vector<fs::path> learners_folders(const fs::path& top, const std::vector<Exercise>& exercises) {
    std::vector<fs::path> level{top}, found;
    for (int depth = 0; depth <= deepest && found.empty(); ++depth) {
        std::vector<fs::path> below;
        for (const fs::path& folder : level) {
            if (has_lessons_begun(folder, exercises)) found.push_back(folder);
            if (below.size() > most_entries) continue;
            for (fs::path& one : next_level(folder)) below.push_back(std::move(one));
        }
        level = std::move(below);
    }
    return found;
}

/// Returns files named like a lesson's headers, in a learner's folder or its subfolders.
std::vector<fs::path> strays(const fs::path& folder, const Exercise& exercise, int depth = 0) {
    std::vector<fs::path> found;
    std::error_code none;
    for (const fs::path& entry : entries_of(folder)) {
        const auto is_like = [&](const std::string& header) { return plain_name(entry) == plain_name(header); };
        if (fs::is_regular_file(entry, none) && std::ranges::any_of(exercise.headers, is_like)) found.push_back(entry);
    }
    if (depth < deepest)
        for (const fs::path& one : next_level(folder))
            for (fs::path& stray : strays(one, exercise, depth + 1)) found.push_back(std::move(stray));
    return found;
}

std::string name_of(const fs::path& folder) {
    fs::path name = fs::absolute(folder).lexically_normal();
    if (!name.has_filename()) name = name.parent_path();
    return name.filename().string();
}

bool is_folder(const fs::path& path) {
    std::error_code none;
    return fs::is_directory(path, none);
}

[[noreturn]] void refuse(const fs::path& path) {
    throw error_at({path.string()}, "there is no such folder; a learner's folder has folders such as 1-rays in it");
}

}  // namespace

HandedIn handed_in(const Workspace& teacher, const fs::path& folder) {
    if (!is_folder(folder)) refuse(folder);
    HandedIn in{name_of(folder), open_workspace(teacher.root, fs::absolute(folder))};
    Workspace& workspace = in.workspace;
    const fs::path top = workspace.folder;
    const std::vector<fs::path> found = learners_folders(top, workspace.exercises);
    if (!found.empty()) workspace.folder = found.front();
    if (workspace.folder != top)
        in.notes.push_back(note(
            folder,
            fmt::format("its lessons are in {}{}", shown(workspace.folder),
                        found.size() > 1 ? ", and others in " + shown(found[1]) + ", which are not looked at" : "")));
    for (const Exercise& exercise : workspace.exercises) {
        const fs::path lesson = lesson_in(workspace.folder, exercise);
        if (!lesson.empty()) {
            if (lesson != workspace.headers_of(exercise)) workspace.called_otherwise[exercise.name] = lesson;
            continue;
        }
        const std::vector<fs::path> elsewhere = strays(top, exercise);
        if (elsewhere.empty()) continue;
        in.notes.push_back(note(
            elsewhere.front(), fmt::format("this is not looked at: lesson {} is in {}; move it there", exercise.number,
                                           shown(workspace.header(exercise, exercise.headers.front()).parent_path()))));
    }
    if (found.empty() && in.notes.empty())
        in.notes.push_back(note(folder, "there is no lesson in it: no folder such as 1-rays with headers"));
    return in;
}

std::vector<HandedIn> all_handed_in(const Workspace& teacher, const std::vector<fs::path>& paths,
                                    const std::function<void(const std::string&)>& say) {
    std::vector<fs::path> folders;
    for (const fs::path& path : paths) {
        std::error_code none;
        if (!fs::exists(path, none)) refuse(path);
        if (is_folder(path)) folders.push_back(path);
        else say(note(path, "this is no folder; it is left out"));
    }
    if (folders.empty()) refuse(paths.front());
    std::vector<HandedIn> all;
    for (const fs::path& folder : folders) all.push_back(handed_in(teacher, folder));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto has_its_name = [&](const fs::path& other) { return name_of(other) == name_of(folders[i]); };
        if (std::ranges::count_if(folders, has_its_name) > 1) all[i].learner = folders[i].lexically_normal().string();
        for (const std::string& one : all[i].notes) say(one);
    }
    return all;
}

}  // namespace glassbox::learn
