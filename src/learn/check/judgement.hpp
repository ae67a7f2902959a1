#pragma once
#include <string>
#include <vector>

#include "learn/check/test_run.hpp"
#include "learn/course/progress.hpp"

namespace glassbox::learn {

/// What a test run says of one function.
struct FunctionJudgement {
    State state = State::unknown;
    std::string waits_for;  ///< the function that must be written, or right, before anything can be said of this one
};

/// What a test run says of an exercise, function by function, and the one thing to look at first.
struct Judgement {
    std::vector<FunctionJudgement> functions;  ///< one for each of the exercise's
    const Function* function = nullptr;  ///< which to look at first; null if all is well, or no function is at fault
    const CaseResult* shown = nullptr;   ///< which failed case to look at first; null if there is none
    int failed = 0;                      ///< how many cases fail
    int waiting = 0;                     ///< how many cannot be run until a function is written
};

/// Goes through the functions in the order of writing. A case that ends only because it calls a function that is not
/// written yet has not failed: the function that it tests waits for that one. So does a function that is right by
/// itself and wrong only with others, while one of those is wrong by itself. The result points into the arguments.
Judgement judged(const Exercise& exercise, const TestRun& run);

}  // namespace glassbox::learn
