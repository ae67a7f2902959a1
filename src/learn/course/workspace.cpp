#include "learn/course/workspace.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <span>

#include "learn/course/starter.hpp"
#include "output/whole_file.hpp"
#include "scene/shipped.hpp"
#include "scene/suggestion.hpp"
#include "scene/text_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_header = 4 << 20;  // bytes; nobody writes that much by hand

bool has_lessons(const fs::path& folder) {
    std::error_code none;
    return fs::is_regular_file(folder / "lessons/1-rays/exercise.toml", none);
}

fs::path find_root(const fs::path& here) {
    for (fs::path folder = fs::absolute(here).lexically_normal();; folder = folder.parent_path()) {
        if (has_lessons(folder)) return folder;
        if (folder == folder.parent_path()) break;
    }
    if (fs::path shipped = shipped_folder(); has_lessons(shipped)) return shipped;
    throw Error(
        "glassbox learn: error: the lessons are not here, nor where this program was built or installed; go into the "
        "folder of Glassbox's source, the one with lessons/ in it");
}

void write_text(const fs::path& path, const std::string& text) { write_whole(path, std::as_bytes(std::span(text))); }

}  // namespace

std::string Workspace::starter(const Exercise& exercise, const std::string& name) const {
    return starter_from(read_text(solution(exercise, name)), exercise, name);
}

Workspace open_workspace(const fs::path& here, const fs::path& folder) {
    std::error_code none;
    Workspace workspace;
    workspace.root = find_root(here);
    const bool is_installed = !fs::exists(workspace.root / "CMakeLists.txt", none);
    if (is_installed) workspace.program = "glassbox";
    workspace.usual_folder = (is_installed ? fs::absolute(here).lexically_normal() : workspace.root) / "my";
    workspace.folder = folder.empty() ? workspace.usual_folder : fs::absolute(here / folder).lexically_normal();
    if (!workspace.folder.has_filename()) workspace.folder = workspace.folder.parent_path();  // "my/"
    if (fs::exists(workspace.folder, none) && !fs::is_directory(workspace.folder, none))
        throw error_at({(folder.empty() ? workspace.folder : folder).string()},
                       "this is not a folder; name a folder, or one that is to be made");
    workspace.exercises = read_exercises(workspace.root);
    return workspace;
}

fs::path make_folder(const fs::path& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed)
        throw error_at({folder.string()},
                       fmt::format("cannot make this folder: {}; name another one with --folder", failed.message()));
    return folder;
}

fs::path new_folder(const fs::path& folder) {
    std::error_code failed;
    fs::remove_all(folder, failed);
    return make_folder(folder);
}

void check_room(const fs::path& folder) {
    const fs::path trial = folder / fmt::format("trial-{}", ::getpid());
    write_text(trial, std::string(64 << 10, '\n'));
    std::error_code none;
    fs::remove(trial, none);
}

const Exercise& exercise_called(const Workspace& workspace, std::string_view name) {
    std::vector<std::string> names;
    for (const Exercise& exercise : workspace.exercises) {
        const std::string bare = exercise.name.substr(exercise.name.find('-') + 1);
        if (name == std::to_string(exercise.number) || name == exercise.name || name == bare) return exercise;
        names.push_back(bare);
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    throw Error(fmt::format("glassbox learn: error: there is no lesson {}; {}, or its number", in_quotes(name),
                            suggestion(name, known)));
}

bool make_starters(const Workspace& workspace, const Exercise& exercise) {
    const fs::path folder = workspace.headers_of(exercise);
    std::error_code failed;
    if (fs::is_directory(folder, failed)) return false;
    // All or nothing: made under a temporary name first.
    const fs::path making = workspace.hidden() / fmt::format("new-{}-{}", exercise.name, ::getpid());
    make_folder(making);
    for (const std::string& header : exercise.headers) write_text(making / header, workspace.starter(exercise, header));
    fs::rename(making, folder, failed);
    if (!failed) return true;
    const std::string why = failed.message();
    fs::remove_all(making, failed);
    if (fs::is_directory(folder, failed)) return false;  // another process was faster
    throw error_at({folder.string()}, fmt::format("cannot make this folder: {}; name another one with --folder", why));
}

void check_begun(const Workspace& workspace, const Exercise& exercise) {
    std::error_code none;
    if (!fs::is_directory(workspace.headers_of(exercise), none))
        throw Error(fmt::format("{} is not begun: '{} learn test {}' makes the files that you write",
                                shown(workspace.headers_of(exercise)), workspace.program, exercise.number));
}

fs::path replace_header(const Workspace& workspace, const Exercise& exercise, const std::string& header,
                        const std::string& text) {
    const fs::path path = workspace.header(exercise, header);
    make_folder(path.parent_path());
    fs::path kept;
    std::error_code failed;
    if (fs::exists(fs::symlink_status(path, failed))) {
        if (!why_unreadable(path) && fs::is_regular_file(path, failed) && fs::file_size(path, failed) == text.size() &&
            read_text(path) == text)
            return {};
        for (int number = 1; kept.empty() || fs::exists(fs::symlink_status(kept, failed)); ++number)
            kept = path.string() + "." + std::to_string(number);
        fs::rename(path, kept, failed);
        if (failed)
            throw error_at({path.string()},
                           fmt::format("cannot be kept as {}: {}; move it away", kept.string(), failed.message()));
    }
    write_text(path, text);
    return kept;
}

std::vector<fs::path> reset(const Workspace& workspace, const Exercise& exercise) {
    std::vector<fs::path> kept;
    for (const std::string& header : exercise.headers) {
        fs::path one = replace_header(workspace, exercise, header, workspace.starter(exercise, header));
        if (!one.empty()) kept.push_back(std::move(one));
    }
    return kept;
}

std::string read_header(const Workspace& workspace, const Exercise& exercise, const std::string& header) {
    const fs::path path = workspace.header(exercise, header);
    const Place place{shown(path)};
    const std::string back = fmt::format("'{} learn reset {}' puts the starter there, and keeps what is there now",
                                         workspace.program, exercise.number);
    std::error_code failed;
    if (!fs::exists(path, failed)) throw error_at(place, "there is no such file: was it deleted, or renamed? " + back);
    if (!fs::is_regular_file(path, failed)) throw error_at(place, "this is not a plain file; " + back);
    if (fs::file_size(path, failed) > largest_header)
        throw error_at(place, fmt::format("is larger than {} MiB; it must be a header that you write; {}",
                                          largest_header >> 20, back));
    return read_text(path);
}

std::string shown(const fs::path& path) {
    std::error_code failed;
    const fs::path near = fs::proximate(path, failed);
    return failed || near.empty() || *near.begin() == ".." ? path.string() : near.string();
}

}  // namespace glassbox::learn
