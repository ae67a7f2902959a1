#pragma once
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "learn/check/judgement.hpp"
#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// How a known mistake fails a test case: a line of mistakes.json.
struct Trace {
    std::string mistake;      ///< its name
    std::string test;         ///< the test case, with its scalar
    std::string got;          ///< what was checked and what came out, or how it ended
    std::string checks = {};  ///< CaseResult::checks; "" if that is not known

    bool operator==(const Trace&) const = default;
};

/// Returns what a run of the tests with this mistake leaves behind: a trace for each case that fails.
std::vector<Trace> traces_of(const std::string& mistake, const TestRun& run);

/// Whether two traces of a test have the same result: the same words, and numbers that differ by at most 1e-6 of the
/// larger.
bool same_got(std::string_view a, std::string_view b);

/// Returns the known mistakes that a run may have: those whose every failing test fails here, too, with the same result
/// in the same checks; the one with most failing tests first. Ignores tests that fail here because a function is not
/// written yet.
std::vector<std::string> candidates(const TestRun& run, const std::vector<Trace>& known);

/// What the detective says of a failed run.
struct Recognised {
    std::string name;        ///< of the classic mistake that explains the failure that is shown; "" if none does
    std::string looks_like;  ///< what to say about it
    std::string also;        ///< of another mistake, in another function or in the same; "" for none
    std::string also_looks_like;
    std::string description;  ///< where no mistake is named: what the function's checks have in common; may be ""
};

/// Returns what a failed run of a lesson's tests looks like, by its mistakes.json and mistakes.toml. A mistake is named
/// only if it, or it and another one, explain every failure of the function that is looked at first.
Recognised recognised(const Exercise& exercise, const TestRun& run, const Judgement& judgement);

/// lessons/N-name/mistakes.json: an array, one trace per line, in the order given. Reading throws Error; a missing file
/// has no traces.
std::vector<Trace> read_traces(const std::filesystem::path& file);
std::string written(const std::vector<Trace>& traces);

/// Writes the headers of an exercise's solution, with a mistake in it, to a folder.
void make_mistaken_headers(const Workspace& workspace, const Exercise& exercise, const Mistake& mistake,
                           const std::filesystem::path& folder);

/// Returns what each mistake of a lesson leaves behind, sorted by mistake and test. Compiles and runs two at a time;
/// calls `done` after each, from any thread.
std::vector<Trace> traces_of_all(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                                 const std::function<void(const Mistake&, const TestRun&)>& done,
                                 const std::stop_token& stop = {});

}  // namespace glassbox::learn
