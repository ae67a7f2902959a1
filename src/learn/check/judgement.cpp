#include "learn/check/judgement.hpp"

#include <algorithm>

namespace glassbox::learn {
namespace {

/// The function that is not written yet, if that alone ended the case; else "".
std::string missing_in(const CaseResult& one) { return one.failure ? one.failure->not_written() : ""; }

bool fails(const CaseResult& one) { return one.failure && missing_in(one).empty(); }

/// Judges a function by the cases that test it: what is wrong takes precedence over what is missing.
FunctionJudgement judged(const Function& function, const std::vector<const CaseResult*>& cases) {
    FunctionJudgement judgement{cases.empty() ? State::unknown : State::passed, ""};
    for (const CaseResult* one : cases) {
        if (fails(*one)) return {State::failing, ""};
        const std::string missing = missing_in(*one);
        if (missing == function.name) judgement = {State::not_written, ""};
        else if (!missing.empty() && judgement.state == State::passed) judgement = {State::waiting, missing};
    }
    return judgement;
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
    for (const Function& function : exercise.functions) {
        std::vector<const CaseResult*> cases;
        for (const CaseResult& one : run.cases)
            if (function_tested_by(exercise, one.name) == &function) cases.push_back(&one);
        judgement.functions.push_back(judged(function, cases));
        if (judgement.shown) continue;
        judgement.shown = first_to_see(function, judgement.functions.back().state, cases);
        if (judgement.shown) judgement.function = &function;
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
