#include "viewer/model/work/mine.hpp"

#include <charconv>
#include <utility>

#include "learn/course/progress.hpp"
#include "scene/error.hpp"
#include "viewer/model/state/state.hpp"

namespace glassbox {

namespace {

constexpr int last_stage = 5;

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

std::optional<LessonChoice> read_lesson_choice(const std::string& typed) {
    if (typed == "all") return AllLessons{};
    int number = 0;
    const char* const end = typed.data() + typed.size();
    const auto [read, failed] = std::from_chars(typed.data(), end, number);
    if (failed != std::errc{} || read != end || number < 1) return {};
    return number;
}

MineChoice chosen_mine(MineChoice mine, std::optional<LessonChoice> lessons) {
    try {
        if (!mine.workspace)
            mine.workspace = std::make_shared<const learn::Workspace>(
                learn::open_workspace(std::filesystem::current_path(), mine.folder));
        std::string complaint;  // reported by `learn`
        const auto progress = [&] {
            return learn::read_progress(mine.workspace->hidden() / "progress.json", complaint);
        };
        if (!lessons) lessons = learn::present_exercise(*mine.workspace, progress()).number;
        if (const int* const lesson = std::get_if<int>(&*lessons))
            learn::exercise_called(*mine.workspace, std::to_string(*lesson));  // it exists
        mine.chosen = lessons;
        mine.problem.clear();
    } catch (const std::exception& error) {
        mine.problem = without(error.what(), "glassbox learn: error: ");
    }
    return mine;
}

void show_mine(ViewerState& state, std::optional<LessonChoice> lessons) {
    state.mine = chosen_mine(std::move(state.mine), lessons);
    if (!shows_mine(state)) state.beside = Beside::mine;
    if (!state.mine.chosen) return;
    if (!state.mine.before) state.mine.before = state.setup.now().options;
    state.setup.change(for_mine(state.setup.now(), state.mine));
}

void show_last_mine(ViewerState& state) { show_mine(state, state.mine.chosen); }

namespace {

void compute_as_before(ViewerState& state) {
    const std::optional<Options> before = std::exchange(state.mine.before, std::nullopt);
    Setup setup = state.setup.now();
    const Options chosen = for_mine(setup, state.mine).options;
    if (!before || setup.options.scalar != chosen.scalar || setup.options.stage != chosen.stage) return;
    setup.options.scalar = before->scalar;
    setup.options.stage = before->stage;
    state.setup.change(std::move(setup));
}

}  // namespace

void show_beside(ViewerState& state, Beside beside) {
    const bool showed_mine = shows_mine(state);
    state.beside = beside;
    if (shows_mine(state)) show_last_mine(state);
    else if (showed_mine) compute_as_before(state);
}

void toggle_mine(ViewerState& state) { show_beside(state, shows_mine(state) ? Beside::nothing : Beside::mine); }

void step_mine(ViewerState& state, bool on) {
    if (state.mine.is_stepped == on) return;
    if (on) {
        const auto chosen = state.mine.chosen;
        state.mine = chosen_mine(std::move(state.mine), chosen);
    }
    state.mine.is_stepped = on;
    state.step = 0;
    state.playing = false;
}

bool is_of_all(const MineChoice& mine) { return mine.chosen == LessonChoice(AllLessons{}); }

const learn::Exercise* exercise_of(const MineChoice& mine) {
    const int* const lesson = mine.chosen ? std::get_if<int>(&*mine.chosen) : nullptr;
    return lesson ? &learn::exercise_called(*mine.workspace, std::to_string(*lesson)) : nullptr;
}

learn::mine::Lessons lessons_of(const MineChoice& mine) {
    if (!mine.chosen) return {};
    const learn::Exercise* const exercise = exercise_of(mine);
    return exercise ? learn::mine::Lessons{exercise} : learn::mine::drawing_in_double(*mine.workspace);
}

std::vector<std::filesystem::path> files_of(const MineChoice& mine) {
    std::vector<std::filesystem::path> files;
    for (const learn::Exercise* const exercise : lessons_of(mine))
        for (const std::string& header : exercise->headers) files.push_back(mine.workspace->header(*exercise, header));
    return files;
}

Scalar scalar_of(const MineChoice& mine) {
    const learn::Exercise* const exercise = exercise_of(mine);
    const bool by_bounds = exercise && exercise->own_picture == learn::OwnPicture::by_bounds;
    return by_bounds ? Scalar::certified : Scalar::double_;
}

Setup for_mine(Setup setup, const MineChoice& mine) {
    const learn::Exercise* const exercise = exercise_of(mine);
    setup.options.scalar = scalar_of(mine);
    setup.options.stage = exercise ? exercise->stage : last_stage;
    return setup;
}

}  // namespace glassbox
