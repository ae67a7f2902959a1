#include "viewer/model/work/mine.hpp"

#include <utility>

#include "learn/course/progress.hpp"
#include "scene/error.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

namespace {

std::string without(std::string text, const std::string& beginning) {
    return text.starts_with(beginning) ? text.substr(beginning.size()) : text;
}

}  // namespace

bool shows_mine(const ViewerState& state) {
    return state.beside == Beside::mine || state.beside == Beside::mine_difference;
}

bool runs_tests(const ViewerState& state) {
    return shows_mine(state) && state.mine.is_tested && exercise_of(state.mine);
}

MineChoice chosen_mine(MineChoice mine, std::optional<int> lesson) {
    try {
        if (!mine.workspace)
            mine.workspace = std::make_shared<const learn::Workspace>(
                learn::open_workspace(std::filesystem::current_path(), mine.folder));
        std::string complaint;  // reported by `learn`
        const auto progress = [&] {
            return learn::read_progress(mine.workspace->hidden() / "progress.json", complaint);
        };
        mine.lesson = lesson ? learn::exercise_called(*mine.workspace, std::to_string(*lesson)).number
                             : learn::present_exercise(*mine.workspace, progress()).number;
        mine.problem.clear();
    } catch (const std::exception& error) {
        mine.problem = without(error.what(), "glassbox learn: error: ");
    }
    return mine;
}

void show_mine(ViewerState& state, std::optional<int> lesson) {
    state.mine = chosen_mine(std::move(state.mine), lesson);
    if (!shows_mine(state)) state.beside = Beside::mine;
    const learn::Exercise* const exercise = exercise_of(state.mine);
    if (exercise) state.setup.change(for_lesson(state.setup.now(), *exercise));
}

void show_last_mine(ViewerState& state) {
    show_mine(state, state.mine.lesson > 0 ? std::optional(state.mine.lesson) : std::nullopt);
}

void toggle_mine(ViewerState& state) {
    if (shows_mine(state)) state.beside = Beside::nothing;
    else show_last_mine(state);
}

const learn::Exercise* exercise_of(const MineChoice& mine) {
    if (mine.workspace)
        for (const learn::Exercise& exercise : mine.workspace->exercises)
            if (exercise.number == mine.lesson) return &exercise;
    return nullptr;
}

std::vector<std::filesystem::path> files_of(const MineChoice& mine) {
    std::vector<std::filesystem::path> files;
    if (const learn::Exercise* const exercise = exercise_of(mine))
        for (const std::string& header : exercise->headers) files.push_back(mine.workspace->header(*exercise, header));
    return files;
}

Scalar scalar_of(const learn::Exercise& exercise) {
    return exercise.own_picture == learn::OwnPicture::by_bounds ? Scalar::certified : Scalar::double_;
}

Setup for_lesson(Setup setup, const learn::Exercise& exercise) {
    setup.options.scalar = scalar_of(exercise);
    setup.options.stage = exercise.stage;
    return setup;
}

}  // namespace glassbox
