#include "learn/tell_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "learn/check/failing_scene.hpp"
#include "learn/learner.hpp"
#include "learn/telling.hpp"
#include "scene/printable.hpp"
#include "scene/suggestion.hpp"

namespace glassbox::learn {
namespace {

using Stand = ToldTests::Stand;

ToldTests standing(Stand stand, const Exercise& exercise, std::string words) {
    ToldTests told;
    told.stand = stand;
    told.lesson = exercise.number;
    told.words = std::move(words);
    return told;
}

std::optional<ToldRay> ray_of(const Exercise& exercise, const CaseResult& one) {
    std::optional<FailingScene> scene = failing_scene(one.name, *one.failure);
    if (!scene) return {};
    const auto [option, rule] = rule_to_see(exercise, one.name);
    return ToldRay{
        std::move(scene->toml), {scene->pixel.first, scene->pixel.second}, std::string(option), std::string(rule)};
}

/// A case as it went in one scalar.
ToldCase told_case(const Workspace& workspace, const Exercise& exercise, const CaseResult& one) {
    const auto [name, scalar] = name_and_scalar(one.name);
    ToldCase told;
    told.name = name;
    if (!scalar.empty()) told.scalars.emplace_back(scalar);
    if (!one.failure) return told;
    told.waits_for = one.failure->not_written();
    told.state = told.waits_for.empty() ? State::failing : State::waiting;
    if (told.state == State::waiting) return told;
    told.rows = failure_rows(workspace, one);
    told.ray = ray_of(exercise, one);
    return told;
}

/// What is worse comes later.
int badness(State state) { return state == State::failing ? 2 : state == State::waiting ? 1 : 0; }

/// Adds how a case went in another scalar: what is worst is told, in the first scalar where it is so.
void add(std::vector<ToldCase>& cases, ToldCase told) {
    const auto same = std::ranges::find(cases, told.name, &ToldCase::name);
    if (same == cases.end()) cases.push_back(std::move(told));
    else if (badness(told.state) > badness(same->state)) *same = std::move(told);
    else if (told.state == same->state)
        same->scalars.insert(same->scalars.end(), told.scalars.begin(), told.scalars.end());
}

std::vector<ToldFunction> told_functions(const Workspace& workspace, const Exercise& exercise, const TestRun& run,
                                         const Judgement& judgement) {
    std::vector<ToldFunction> functions;
    for (std::size_t i = 0; i < exercise.functions.size(); ++i) {
        const auto& [state, waits_for] = judgement.functions[i];
        functions.push_back({exercise.functions[i].name, state, waits_for, {}});
    }
    functions.emplace_back();
    for (const CaseResult& one : run.cases) {
        const Function* const tested = function_tested_by(exercise, one.name);
        const auto place = tested ? tested - exercise.functions.data() : std::ssize(exercise.functions);
        add(functions[static_cast<std::size_t>(place)].cases, told_case(workspace, exercise, one));
    }
    if (functions.back().cases.empty()) functions.pop_back();
    return functions;
}

/// "3 of 24 tests fail, 5 wait for a function to be written"
std::string summary(const std::vector<ToldFunction>& functions) {
    std::size_t all = 0, failing = 0, waiting = 0;
    for (const ToldFunction& function : functions)
        for (const ToldCase& one : function.cases) {
            ++all;
            failing += one.state == State::failing;
            waiting += one.state == State::waiting;
        }
    std::string text = fmt::format("{} of {} {}", failing, counted(all, "test"), failing == 1 ? "fails" : "fail");
    if (waiting > 0)
        text += fmt::format(", {} {} for a function to be written", waiting, waiting == 1 ? "waits" : "wait");
    return text;
}

std::vector<ToldRow> paragraphs(const Recognised& recognised) {
    std::vector<ToldRow> all;
    const auto add = [&](const char* heading, const std::string& text) {
        if (!text.empty()) all.push_back({heading, text});
    };
    if (!recognised.name.empty()) add("This looks familiar.", recognised.looks_like);
    add("What the checks show:", recognised.description);
    add("Also:", recognised.also_looks_like);
    return all;
}

ToldTests told_error(const Exercise& exercise, const CompileError& error) {
    const auto [where, what] = error_heading(error);
    ToldTests told = standing(Stand::does_not_compile, exercise, where.empty() ? what : where + ": " + what);
    told.error = error;
    if (!error.plain.empty()) told.rows.push_back({"", printable(error.plain)});
    if (!error.message.empty()) told.rows.push_back({"compiler", printable(error.message)});
    return told;
}

ToldTests told_run(const Workspace& workspace, const Exercise& exercise, const TestRun& run,
                   const Judgement& judgement) {
    ToldTests told = standing(Stand::done, exercise, "");
    told.passed = run.passed();
    told.functions = told_functions(workspace, exercise, run, judgement);
    told.words = !run.disturbed.empty() ? run.disturbed
                 : told.passed          ? all_pass_text(exercise, run)
                                        : summary(told.functions);
    if (judgement.shown && judgement.shown->failure->not_written().empty())
        told.first = name_and_scalar(judgement.shown->name).first;
    return told;
}

}  // namespace

const ToldCase* find_case(const ToldTests& tests, const std::string& name) {
    for (const ToldFunction& function : tests.functions)
        for (const ToldCase& one : function.cases)
            if (one.name == name) return &one;
    return nullptr;
}

void tell_tests(const Workspace& workspace, const Exercise& exercise, const std::function<void(ToldTests)>& tell,
                const std::stop_token& stop) {
    const auto say = [&](const std::string& words) { tell(standing(Stand::running, exercise, words)); };
    try {
        check_begun(workspace, exercise);
        say(fmt::format("testing lesson {}", exercise.number));
        Learner learner(workspace, say);
        const Exercise& own = learner.lesson(exercise.name);
        const auto so_far = [&](const TestRun& run) {
            ToldTests told = told_run(workspace, own, run, judged(own, run));
            told.stand = Stand::running;
            told.words = so_far_words(own, run);
            tell(std::move(told));
        };
        const TestedLesson tested = learner.test(own, stop, so_far);
        if (tested.run.stopped) return;
        if (tested.run.error) return tell(told_error(own, *tested.run.error));
        ToldTests told = told_run(workspace, own, tested.run, tested.judgement);
        told.about_first = paragraphs(tested.recognised);
        tell(std::move(told));
    } catch (const Error& error) {
        if (!stop.stop_requested()) tell(standing(Stand::not_there, exercise, error.what()));
    }
}

}  // namespace glassbox::learn
