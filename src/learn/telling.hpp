#pragma once
#include <string>
#include <string_view>

#include "learn/learner.hpp"

namespace glassbox::learn {

/// How text is set for a terminal; without one, as it is.
struct Paint {
    bool colours = false;

    std::string good(std::string_view text) const { return set("32", text); }
    std::string bad(std::string_view text) const { return set("31", text); }
    std::string strong(std::string_view text) const { return set("1", text); }
    std::string faint(std::string_view text) const { return set("2", text); }

private:
    std::string set(std::string_view code, std::string_view text) const;
};

/// The command line that does something, as it must be typed here: "./glassbox learn test 2".
std::string command_line(const Workspace& workspace, std::string_view words);

/// All lessons with a bar each, the present one's functions, and what to do next.
std::string status_text(Learner& learner, const Paint& paint);

/// Of all that is wrong the first thing, in lines: where it does not compile, or the failed test to look at.
std::string first_wrong_text(const Workspace& workspace, const Exercise& exercise, const TestRun& run,
                             const Judgement& judgement, const Paint& paint);

/// That all passes in the scalars that were tested so far: a line.
std::string so_far_text(const Exercise& exercise, const TestRun& run, const Paint& paint);

/// What came of a test, and of what is wrong one thing only.
std::string tested_text(Learner& learner, const Exercise& exercise, const TestedLesson& tested, const Paint& paint);

/// How far what a test got is from what it expected, in ulps, where that tells of rounding; "" where another number
/// came out: one of another sign, or a million ulps and more away.
std::string ulps_text(const Failure& failure);

/// What is wrong with a program that does not compile.
std::string error_text(const CompileError& error, const Paint& paint);

/// A hint; `tier` counts from 1.
std::string hint_text(const Workspace& workspace, const Exercise& exercise, const Function& function, int tier,
                      const Paint& paint);

}  // namespace glassbox::learn
