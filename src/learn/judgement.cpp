#include "learn/judgement.hpp"

#include <algorithm>

namespace glassbox::learn {
namespace {

/// What one case says of the function that it tests.
State said_by(const CaseResult& one, const Function& function) {
    if (!one.failure) return State::passed;
    const std::string missing = one.failure->not_written();
    if (missing.empty()) return State::failing;
    return missing == function.name ? State::not_written : State::unknown;
}

}  // namespace

Judgement judged(const Exercise& exercise, const TestRun& run) {
    Judgement judgement;
    judgement.failed = static_cast<int>(std::count_if(run.cases.begin(), run.cases.end(),
                                                      [](const CaseResult& one) { return one.failure.has_value(); }));
    const CaseResult* waiting = nullptr;
    for (const Function& function : exercise.functions) {
        bool passed = false, failing = false, not_written = false, unknown = false;
        const CaseResult* first = nullptr;  // the first that fails; one that is not just unwritten goes before
        for (const CaseResult& one : run.cases) {
            if (function_tested_by(exercise, one.name) != &function) continue;
            const State said = said_by(one, function);
            const bool worse = said == State::failing && !failing;
            if (worse || (said == State::not_written && !first)) first = &one;
            if (said == State::unknown && !waiting) waiting = &one;
            passed |= said == State::passed;
            failing |= said == State::failing;
            not_written |= said == State::not_written;
            unknown |= said == State::unknown;
        }
        judgement.functions.push_back(failing              ? State::failing
                                      : not_written        ? State::not_written
                                      : passed && !unknown ? State::passed
                                                           : State::unknown);
        if (first && !judgement.shown) {
            judgement.shown = first;
            judgement.function = &function;
        }
    }
    if (!judgement.shown) judgement.shown = waiting;
    for (const CaseResult& one : run.cases)
        if (one.failure && !judgement.shown) judgement.shown = &one;  // of a case that no function claims
    return judgement;
}

}  // namespace glassbox::learn
