// What every lesson's exercise must satisfy, for the lesson named on the command line: the starter compiles and fails
// with the names of its own functions; the solution passes; each classic mistake is caught, and the detective names it
// and no other.
#include <doctest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <mutex>
#include <set>
#include <sstream>

#include "learn/build/function_line.hpp"
#include "learn/check/detective.hpp"
#include "learn/check/judgement.hpp"
#include "learn/learner.hpp"
#include "learn/prepared.hpp"
#include "output/folder.hpp"
#include "scene/text_file.hpp"

using namespace glassbox;
using namespace glassbox::learn;
namespace fs = std::filesystem;

namespace {

std::string lesson;

/// One folder for the tests of all lessons, so that the toolchain is made only once.
Workspace workspace() { return open_workspace(ROOT, FOLDER); }

Toolchain tools(const Workspace& all) {
    return toolchain(all, [](const std::string&) {});
}

/// The folder for a program of this test.
fs::path work_folder(const Workspace& all, const std::string& name) {
    fs::path folder = all.hidden() / "exercises" / lesson / name;
    fs::create_directories(folder);
    return folder;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string without_indent(const std::string& line) {
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

/// What is wrong with a run, for the failure message of this test.
std::string first_trouble(const TestRun& run) {
    if (run.error) return run.error->place.file + ": " + run.error->message;
    if (!run.disturbed.empty()) return run.disturbed;
    for (const CaseResult& one : run.cases)
        if (one.failure) return one.name + ": " + one.failure->expression + one.failure->threw + one.failure->died;
    return "";
}

TEST_CASE("the starter is the solution, but for what is to be written") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    std::set<std::string> asked_for;
    for (const std::string& header : exercise.headers) {
        CAPTURE(header);
        const std::vector<std::string> solution = lines_of(read_text(all.solution(exercise, header)));
        auto at = solution.begin();
        for (const std::string& line : lines_of(all.starter(exercise, header))) {
            const std::string code = without_indent(line);
            if (code == "#include <not_written.hpp>" || code.starts_with("// Your turn")) continue;
            if (const std::size_t call = code.find("not_written<"); call != std::string::npos) {
                const std::size_t open = code.find("(\"", call), close = code.find("\")", call);
                REQUIRE(close != std::string::npos);
                asked_for.insert(code.substr(open + 2, close - open - 2));
                continue;
            }
            const auto found = std::find(at, solution.end(), line);
            CHECK_MESSAGE(found != solution.end(), "not in the solution, or not in this order: ", line);
            if (found != solution.end()) at = found + 1;
        }
    }
    std::set<std::string> functions;
    for (const Function& function : exercise.functions) {
        functions.insert(function.name);
        CHECK(all.starter(exercise, function.header).find('"' + function.name + '"') != std::string::npos);
    }
    CHECK(asked_for == functions);
}

TEST_CASE("each function is found in the starter and, where it is written, in the solution") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    std::set<std::pair<std::string, std::size_t>> begins;
    for (const Function& function : exercise.functions) {
        CAPTURE(function.name);
        const std::string starter = all.starter(exercise, function.header);
        const std::string solution = read_text(all.solution(exercise, function.header));
        const std::size_t to_write = line_of_function(starter, starter, function.name);
        REQUIRE(to_write > 0);
        CHECK(lines_of(starter)[to_write - 1].find('"' + function.name + '"') != std::string::npos);
        const std::size_t begin = line_of_function(solution, starter, function.name);
        CHECK(begin > 0);
        CHECK_MESSAGE(begins.emplace(function.header, begin).second, "another function begins there, too");
    }
}

TEST_CASE("the starter compiles, and fails with the names of its own functions") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    fs::remove_all(all.headers_of(exercise));
    REQUIRE(make_starters(all, exercise));
    const TestRun run = run_tests(all, exercise, tools(all), {all.headers_of(exercise), work_folder(all, "starter")});
    REQUIRE_MESSAGE(!run.error, first_trouble(run));
    CHECK(run.disturbed == "");
    std::set<std::string> functions, missing;
    for (const Function& function : exercise.functions) functions.insert(function.name);
    for (const CaseResult& one : run.cases) {
        if (!one.failure) continue;
        CHECK_MESSAGE(!one.failure->not_written().empty(), one.name);
        missing.insert(one.failure->not_written());
    }
    CHECK(!missing.empty());
    CHECK(std::includes(functions.begin(), functions.end(), missing.begin(), missing.end()));
    const Judgement judgement = judged(exercise, run);
    for (std::size_t i = 0; i < exercise.functions.size(); ++i)
        CHECK_MESSAGE(judgement.functions[i].state != State::passed, exercise.functions[i].name);
    REQUIRE(judgement.function);
    CHECK(judgement.function == exercise.functions.data());  // the first function to write is reported first
}

TEST_CASE("the solution passes, in every scalar, and each function has its tests") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    TestRequest request{all.root / exercise.core, work_folder(all, "solution")};
    request.so_far = [](const TestRun& so_far) {  // only where long double takes longer
        CHECK(so_far.passed());
        CHECK(so_far.scalars == std::vector<std::string>{"double", "float"});
    };
    const TestRun run = run_tests(all, exercise, tools(all), request);
    CHECK_MESSAGE(run.passed(), first_trouble(run));
    const bool in_every = read_text(all.root / exercise.tests.front()).find("EVERY_SCALAR") != std::string::npos;
    CHECK(run.scalars.size() == (in_every ? 3 : 1));
    const Judgement judgement = judged(exercise, run);
    for (std::size_t i = 0; i < exercise.functions.size(); ++i)
        CHECK_MESSAGE(judgement.functions[i].state == State::passed, exercise.functions[i].name);
    for (const Function& function : exercise.functions)
        for (const std::string& part : function.tests)
            CHECK_MESSAGE(std::any_of(run.cases.begin(), run.cases.end(),
                                      [&](const CaseResult& one) { return one.name.find(part) != std::string::npos; }),
                          "no test is called ", part);
}

TEST_CASE("a header without its last brace is named itself, at the brace that is never closed") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    const fs::path headers = work_folder(all, "unclosed") / "headers";
    for (const std::string& broken : exercise.headers) {
        CAPTURE(broken);
        fs::create_directories(headers);
        for (const std::string& header : exercise.headers)
            fs::copy_file(all.solution(exercise, header), headers / header, fs::copy_options::overwrite_existing);
        const std::string solution = read_text(all.solution(exercise, broken));
        std::ofstream(headers / broken) << solution.substr(0, solution.rfind('}'));
        const TestRun run = run_tests(all, exercise, tools(all), {headers, work_folder(all, "unclosed")});
        REQUIRE(run.error);
        CHECK(run.error->yours);
        CHECK(fs::path(run.error->place.file) == headers / broken);
        // The last brace closes the namespace, which the header opens first.
        CHECK(run.error->source.starts_with("namespace glassbox"));
        CHECK(run.error->place.column == run.error->source.size());
        CHECK(run.error->plain.starts_with("This { is never closed"));
    }
}

TEST_CASE("each mistake is caught, and recognised as itself; mistakes.json is what they do now") {
    const Workspace all = workspace();
    const Exercise& exercise = exercise_called(all, lesson);
    const std::string recorded = read_text(exercise.lesson / "mistakes.json");
    CHECK(read_mistakes(exercise).size() >= 7);
    std::mutex mutex;  // doctest's checks must be made by one thread at a time
    std::vector<std::pair<std::string, std::string>> told;
    const std::vector<Trace> now =
        traces_of_all(all, exercise, tools(all), [&](const Mistake& mistake, const TestRun& run) {
            const std::lock_guard lock(mutex);
            told.emplace_back(mistake.name, run.error ? "does not compile: " + run.error->message
                                                      : recognised(exercise, run, judged(exercise, run)).name);
        });
    for (const auto& [mistake, recognised] : told) CHECK(recognised == mistake);
    CHECK_MESSAGE(written(now) == recorded, "make it anew: glassbox learn mistake ", exercise.number, " --record");
}

}  // namespace

/// main prepare: makes the toolchain of all lessons' tests. main N-name …: tests a lesson.
int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << argv[0] << ": error: name a lesson, such as 2-spheres\n";
        return 2;
    }
    lesson = argv[1];
    if (lesson == "prepare") {
        const test::Prepared prepared(workspace().hidden());
        tools(workspace());
        return 0;
    }
    doctest::Context context(argc, argv);
    return context.run();
}
