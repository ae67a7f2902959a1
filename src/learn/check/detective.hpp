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
    std::string mistake;  ///< its name
    std::string test;     ///< the test case, with its scalar
    std::string got;      ///< what was checked and what came out, or how it ended

    bool operator==(const Trace&) const = default;
};

/// What a run of the tests with this mistake leaves behind, a trace for each case that fails.
std::vector<Trace> traces_of(const std::string& mistake, const TestRun& run);

/// Whether two traces of a test got the same: the same words, and numbers that differ by at most 1e-6 of the larger.
bool same_got(std::string_view a, std::string_view b);

/// Which of the known mistakes a run looks like: of those whose every failing test fails here, too, with the same got,
/// one that the case `shown` is among, if there is any, and of those the one with most such tests. Tests that fail here
/// since a function is not written yet are left out of account. "" if it looks like none.
std::string looks_like(const TestRun& run, const std::vector<Trace>& known, const CaseResult* shown = nullptr);

/// A classic mistake, recognised.
struct Recognised {
    std::string name;        ///< "" for none
    std::string looks_like;  ///< what is to be said of it, and of which function, if it is not the one looked at first
};

/// What a failed run of a lesson's tests looks like, by its mistakes.json and mistakes.toml.
Recognised recognised(const Exercise& exercise, const TestRun& run, const Judgement& judgement);

/// lessons/N-name/mistakes.json: an array, one trace a line, in the order given. Reading throws Error; a file that is
/// not there has no traces.
std::vector<Trace> read_traces(const std::filesystem::path& file);
std::string written(const std::vector<Trace>& traces);

/// Makes the headers of an exercise's solution with a mistake in it, in a folder.
void make_mistaken_headers(const Workspace& workspace, const Exercise& exercise, const Mistake& mistake,
                           const std::filesystem::path& folder);

/// What each mistake of a lesson leaves behind, sorted by mistake and test. Each is compiled and run, two at a time;
/// `done` is told after each, from any thread.
std::vector<Trace> traces_of_all(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                                 const std::function<void(const Mistake&, const TestRun&)>& done,
                                 const std::stop_token& stop = {});

}  // namespace glassbox::learn
