#include "learn/check/judgement.hpp"

#include <algorithm>

namespace glassbox::learn {
namespace {

/// The function that is not written yet, if that is all that is wrong with the case; else "".
std::string missing_in(const CaseResult& one) { return one.failure ? one.failure->not_written() : ""; }

bool fails(const CaseResult& one) { return one.failure && missing_in(one).empty(); }

/// Judges a function by the cases that test it. If it is not written what is wrong there is another's fault; else what
/// is wrong takes precedence over what is missing.
FunctionJudgement judged(const Function& function, const TestRun& run, const std::vector<const CaseResult*>& cases) {
    if (std::ranges::any_of(run.cases, [&](const CaseResult& one) { return one.missing == function.name; }))
        return {State::not_written, ""};
    FunctionJudgement judgement{cases.empty() ? State::unknown : State::passed, ""};
    for (const CaseResult* one : cases) {
        if (fails(*one)) return {State::failing, ""};
        const std::string missing = missing_in(*one);
        if (!missing.empty() && judgement.state == State::passed) judgement = {State::waiting, missing};
    }
    return judgement;
}

/// Whether a case tests the function by itself.
bool tests_alone(const CaseResult& one, const Function& function) {
    return !function.tests.empty() && one.name.find(function.tests.front()) != std::string::npos;
}

/// Where some functions fail by themselves, those that only fail with others wait for the first of them: what is wrong
/// there may be wrong for that reason.
void let_wait(std::vector<FunctionJudgement>& judgements, const Exercise& exercise,
              const std::vector<std::vector<const CaseResult*>>& cases) {
    const auto fails_alone = [&](std::size_t i) {
        return judgements[i].state == State::failing && std::ranges::any_of(cases[i], [&](const CaseResult* one) {
                   return fails(*one) && tests_alone(*one, exercise.functions[i]);
               });
    };
    std::vector<std::size_t> at_fault;
    for (std::size_t i = 0; i < judgements.size(); ++i)
        if (fails_alone(i)) at_fault.push_back(i);
    if (at_fault.empty()) return;
    for (std::size_t i = 0; i < judgements.size(); ++i)
        if (judgements[i].state == State::failing && std::ranges::find(at_fault, i) == at_fault.end())
            judgements[i] = {State::waiting, exercise.functions[at_fault.front()].name};
}

/// Returns the case of a function at fault to look at first; null for any other function.
const CaseResult* first_to_see(const Function& function, State state, const std::vector<const CaseResult*>& cases) {
    for (const CaseResult* one : cases)
        if (state == State::failing ? fails(*one) : state == State::not_written && missing_in(*one) == function.name)
            return one;
    return nullptr;
}

}  // namespace

Judgement judged(const Exercise& exercise, const TestRun& run) {
    Judgement judgement;
    for (const CaseResult& one : run.cases) {
        judgement.failed += fails(one);
        judgement.waiting += !missing_in(one).empty();
    }
    std::vector<std::vector<const CaseResult*>> cases(exercise.functions.size());
    for (const CaseResult& one : run.cases)
        if (const Function* function = function_tested_by(exercise, one.name))
            cases[static_cast<std::size_t>(function - exercise.functions.data())].push_back(&one);
    for (std::size_t i = 0; i < cases.size(); ++i)
        judgement.functions.push_back(judged(exercise.functions[i], run, cases[i]));
    let_wait(judgement.functions, exercise, cases);
    for (std::size_t i = 0; i < cases.size() && !judgement.shown; ++i) {
        judgement.shown = first_to_see(exercise.functions[i], judgement.functions[i].state, cases[i]);
        if (judgement.shown) judgement.function = &exercise.functions[i];
    }
    if (judgement.shown) return judgement;
    // No function is at fault by its own tests. Look at one that others wait for; else at a case that no function
    // claims.
    for (const Function& function : exercise.functions)
        for (const CaseResult& one : run.cases)
            if (!judgement.shown && missing_in(one) == function.name) {
                judgement.shown = &one;
                judgement.function = &function;
            }
    for (const CaseResult& one : run.cases)
        if (!judgement.shown && one.failure) judgement.shown = &one;
    return judgement;
}

}  // namespace glassbox::learn
