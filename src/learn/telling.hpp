#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "learn/learner.hpp"
#include "learn/told_tests.hpp"

namespace glassbox::learn {

/// How text is styled for a terminal; plain elsewhere.
struct Paint {
    bool colours = false;
    std::size_t width = 100;  ///< of a line, in characters

    std::string good(std::string_view text) const { return set("32", text); }
    std::string bad(std::string_view text) const { return set("31", text); }
    std::string strong(std::string_view text) const { return set("1", text); }
    std::string faint(std::string_view text) const { return set("2", text); }

private:
    std::string set(std::string_view code, std::string_view text) const;
};

/// Returns a text in lines of at most `width` characters, broken between words; each but the first begins with
/// `indent` spaces, and the first has `indent` characters before it. A longer word has a line of its own.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width);

/// Returns the command line to type here, such as "./glassbox learn test 2".
std::string command_line(const Workspace& workspace, std::string_view words);

/// All lessons with a bar each, the present lesson's functions, and what to do next.
std::string status_text(Learner& learner, const Paint& paint);

/// The first of all that is wrong, in lines: where it does not compile, or the failed test to look at.
std::string first_wrong_text(const Workspace& workspace, const Exercise& exercise, const TestRun& run,
                             const Judgement& judgement, const Paint& paint);

/// What a failed case reports, line by line: the test, what was checked, expected and got, the ray, the inputs.
std::vector<ToldRow> failure_rows(const Workspace& workspace, const CaseResult& one);

/// Returns the option by which the viewer shows the rule that a test is about, and its name: "sphere", "textbook"; ""
/// for the usual one.
std::pair<std::string_view, std::string_view> rule_to_see(const Exercise& exercise, std::string_view test);

/// "All 24 tests of lesson 2 pass.", and what the learner can do now.
std::string all_pass_text(const Exercise& exercise, const TestRun& run);

/// A line that says that all passes in the scalars tested so far.
std::string so_far_words(const Exercise& exercise, const TestRun& run);
std::string so_far_text(const Exercise& exercise, const TestRun& run, const Paint& paint);

/// The result of a test; of what is wrong only the first thing.
std::string tested_text(Learner& learner, const Exercise& exercise, const TestedLesson& tested, const Paint& paint);

/// How far what a test got is from what it expected, in ulps, where that is about rounding; "" where it is simply
/// another number: one of another sign, or a million ulps or more away.
std::string ulps_text(const Failure& failure);

/// Where a program does not compile, "" if that is not known, and that it does not.
ToldRow error_heading(const CompileError& error);

/// What is wrong with a program that does not compile.
std::string error_text(const CompileError& error, const Paint& paint);

/// A hint; `tier` counts from 1.
std::string hint_text(const Workspace& workspace, const Exercise& exercise, const Function& function, int tier,
                      const Paint& paint);

}  // namespace glassbox::learn
