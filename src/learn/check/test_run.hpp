#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "learn/build/compile_error.hpp"
#include "learn/build/toolchain.hpp"
#include "learn/course/workspace.hpp"

namespace glassbox::learn {

/// Returns the function named by an exception of lessons/not_written.hpp; "" for the text of any other.
std::string function_not_written(const std::string& threw);

/// A variable of a test, or a member of one, and its number or its three: "ray.D", 1, 0, 0.
struct Input {
    std::string name;
    std::vector<double> numbers;
};

/// The first thing that went wrong in a test case.
struct Failure {
    std::string file;  ///< the check's place; "" for an exception that no check caught
    std::size_t line = 0;
    std::string expression;             ///< what was checked: "cross(x, y)"
    std::string expected;               ///< "" where the check is a plain condition
    std::string got;                    ///< of a condition its two sides: "3 == 4"
    std::string ulps;                   ///< how far they are apart; "" where it says nothing
    std::string threw;                  ///< what the exception says, if there was one
    std::string died;                   ///< what ended the program during the case, in words
    std::string death;                  ///< the same without what differs from run to run
    std::vector<std::string> contexts;  ///< "size := 8192"
    std::vector<std::string> subcases;  ///< "textbook"
    std::vector<Input> inputs;          ///< what the check was made from
    std::vector<double> ray;            ///< P and D of the ray that was traced last; empty if none was
    std::vector<double> surface;        ///< against which: a sphere's centre and radius, or a triangle's vertices
    bool negated = false;               ///< the condition should not hold

    /// The function that is not written yet, if that is all that went wrong; else "".
    std::string not_written() const;
};

/// How a test case went.
struct CaseResult {
    std::string name;  ///< with the scalar: "at(ray, t) is P + tD<double>"
    std::optional<Failure> failure = {};
    std::string checks = {};   ///< a sign for each: + passed, - failed, ~ failed only sometimes; "" if it has not ended
    std::string missing = {};  ///< the function that is not written yet and ended the case, whatever failed before
};

/// Of each check in a case only so many passes are kept, and so many failures.
inline constexpr int most_checks_kept = 60;  // as check/runner/main.cpp has it

/// A check as it was made once, passed or failed.
struct CheckMade {
    std::string test;  ///< the case
    std::size_t line = 0;
    bool passed = false;
    bool is_condition = false;
    std::string expression;
    std::vector<double> expected, got;  ///< a number or three; of a condition 1 for true; empty for anything else
    std::vector<Input> inputs;
    std::vector<double> ray, surface;  ///< as in Failure
};

/// A case's name without its scalar, and the scalar: "the normal points outwards" and "double", of "…<double>"; "" for
/// a case that is in all programs.
std::pair<std::string_view, std::string_view> name_and_scalar(std::string_view test);

/// How the tests of a lesson went.
struct TestRun {
    std::optional<CompileError> error;  ///< they did not compile; then there are no cases
    std::vector<CaseResult> cases;      ///< in the order of the tests; those after an early end are missing
    std::vector<CheckMade> checks;      ///< of the cases; none where all have passed, or the program died
    std::vector<std::string> scalars;   ///< in which they ran: "double", "float"
    std::string disturbed;              ///< why the cases cannot be trusted, in words; "" if they can
    bool stopped = false;               ///< we were asked to stop

    bool passed() const;
};

/// Whose headers are tested, and how.
struct TestRequest {
    std::filesystem::path headers;             ///< the folder that comes first on the include path
    std::filesystem::path folder;              ///< where the program is made; it must exist
    bool at_once = true;                       ///< try several scalars at the same time, to answer soon
    std::chrono::milliseconds deadline{5000};  ///< for the tests of a scalar
    bool double_first = false;                 ///< try no other scalar where double fails
    /// Called with the results so far when all has passed and only the last scalar takes longer.
    std::function<void(const TestRun&)> so_far = {};
};

/// Compiles a lesson's tests against headers, runs them in subprocesses and reads their reports: for double and float,
/// so that what passes in one and not in the other is not told to pass; if both pass, for long double. Runs programs
/// that have not changed without compiling them again. Throws Error if the machine or the project is not as it should
/// be.
TestRun run_tests(const Workspace& workspace, const Exercise& exercise, const Toolchain& tools,
                  const TestRequest& request, const std::stop_token& stop = {});

/// Returns the include folders of a lesson's programs: the given ones, then ours up to the lesson's stage.
std::vector<std::filesystem::path> includes_of(const Workspace& workspace, const Exercise& exercise,
                                               const std::filesystem::path& headers);

/// Returns the headers of a lesson in that folder, in which to look for a compiler's errors.
OwnHeaders own_headers(const Exercise& exercise, const std::filesystem::path& headers);

}  // namespace glassbox::learn
