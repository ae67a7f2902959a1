#include "learn/learner.hpp"

#include <algorithm>
#include <span>

#include "learn/build/headers.hpp"
#include "learn/check/failing_scene.hpp"
#include "output/whole_file.hpp"

namespace glassbox::learn {
namespace {

namespace fs = std::filesystem;

/// Returns the scene of the ray with which the case fails that is shown; none where it traced none.
std::optional<FailingScene> scene_to_look_at(const Judgement& judgement) {
    const CaseResult* shown = judgement.shown;
    if (!shown || !shown->failure || !shown->failure->not_written().empty()) return {};
    return failing_scene(shown->name, *shown->failure);
}

}  // namespace

State state_of(const Function& function, const LessonProgress& progress) {
    const auto found = progress.functions.find(function.name);
    return found == progress.functions.end() ? State::unknown : found->second;
}

const Function* open_function(const Exercise& exercise, const LessonProgress& progress) {
    const Function* waiting = nullptr;
    for (const Function& function : exercise.functions) {
        const State state = state_of(function, progress);
        if (state != State::passed && state != State::waiting) return &function;
        if (state == State::waiting && !waiting) waiting = &function;
    }
    return waiting;
}

std::string fingerprint_of(const Workspace& workspace, const Exercise& exercise) {
    return fingerprint_of_headers(workspace.headers_of(exercise));
}

Learner::Learner(Workspace workspace, std::function<void(const std::string&)> say, bool is_isolated)
    : workspace_(std::move(workspace)), say_(std::move(say)), is_isolated_(is_isolated) {
    std::string complaint;
    progress_ = read_progress(progress_file(), complaint);
    if (!complaint.empty()) say_(complaint);
}

const Toolchain& Learner::tools() {
    if (tools_ && is_there(*tools_)) return *tools_;
    tools_ = toolchain(workspace_, say_);
    if (is_isolated_) tools_ = isolated(*tools_, workspace_);
    return *tools_;
}

const Exercise& Learner::lesson(const std::string& name) {
    if (!name.empty()) return exercise_called(workspace_, name);
    return present_exercise(workspace_, progress_);
}

bool Learner::is_tested(const Exercise& exercise) {
    return remembered(exercise).tested == fingerprint_of(workspace_, exercise);
}

void Learner::forget(const Exercise& exercise) {
    LessonProgress& progress = remembered(exercise);
    progress.passed = false;
    progress.functions.clear();
    progress.tested.clear();
    save();
}

TestedLesson Learner::test(const Exercise& exercise, const std::stop_token& stop,
                           std::function<void(const TestRun&)> so_far) {
    make_starters(workspace_, exercise);
    for (const std::string& header : exercise.headers)
        read_header(workspace_, exercise, header);  // throws if it cannot be read
    tools();
    const auto start = std::chrono::steady_clock::now();
    TestRequest request{workspace_.headers_of(exercise), make_folder(workspace_.hidden() / exercise.name)};
    request.so_far = std::move(so_far);
    const std::string tested_as = fingerprint_of(workspace_, exercise);

    TestedLesson tested;
    tested.run = run_tests(workspace_, exercise, tools(), request, stop);
    if (tested.run.error && !is_there(*tools_)) {  // deleted in the meantime
        make_folder(request.folder);
        tested.run = run_tests(workspace_, exercise, tools(), request, stop);
    }
    if (tested.run.stopped) return tested;
    tested.judgement = judged(exercise, tested.run);
    if (!tested.run.error && !tested.run.passed())
        tested.recognised = recognised(exercise, tested.run, tested.judgement);
    if (const auto scene = scene_to_look_at(tested.judgement)) {
        write_whole(failing_scene_file(), std::as_bytes(std::span(scene->toml)));
        tested.pixel = scene->pixel;
    }
    LessonProgress& progress = remembered(exercise);
    ++progress.runs;
    progress.passed |= tested.run.passed();
    progress.tested = tested_as;
    if (!tested.run.error) {
        progress.functions.clear();
        for (std::size_t i = 0; i < exercise.functions.size(); ++i)
            progress.functions[exercise.functions[i].name] = tested.judgement.functions[i].state;
    }
    save();
    tested.took = std::chrono::steady_clock::now() - start;
    return tested;
}

const Function* Learner::next_function(const Exercise& exercise, const std::stop_token& stop) {
    if (!is_tested(exercise)) test(exercise, stop);
    return open_function(exercise, remembered(exercise));
}

int Learner::next_hint(const Exercise& exercise, const Function& function) {
    int& shown = remembered(exercise).hints[function.name];
    shown = std::min(shown + 1, hint_tiers);
    save();
    return shown;
}

void Learner::remember_giving_up(const Exercise& exercise) {
    LessonProgress& progress = remembered(exercise);
    if (progress.passed) return;
    progress.gave_up = true;
    save();
}

}  // namespace glassbox::learn
