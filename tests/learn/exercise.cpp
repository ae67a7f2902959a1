#include "learn/course/exercise.hpp"

#include <doctest.h>

#include <fstream>
#include <stop_token>
#include <thread>

#include "learn/build/function_line.hpp"
#include "learn/check/detective.hpp"
#include "learn/check/failing_scene.hpp"
#include "learn/check/judgement.hpp"
#include "learn/check/test_report.hpp"
#include "learn/course/progress.hpp"
#include "learn/course/starter.hpp"
#include "learn/course/workspace.hpp"
#include "learn/learner.hpp"
#include "learn/telling.hpp"
#include "learn/watch.hpp"
#include "output/folder.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using namespace std::chrono_literals;
using glassbox::test::content;
using glassbox::test::Folder;
using glassbox::test::message_of;
namespace fs = std::filesystem;

namespace {

const std::string good = R"(title = "Spheres"
sentence = "You can see them."
core = "src/core/2-spheres"
headers = ["sphere.hpp"]
tests = ["tests/stages/stage2_spheres.cpp"]
scene = "scenes/sphere.toml"
stage = 2
[[function]]
name = "normal"
header = "sphere.hpp"
tests = ["the normal points"]
question = "Which way is up?"
formula = "(p - c)/|p - c|"
line = "return unit(X - sphere.C);"
returns = "Vec3<Real>"
)";

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    return text.replace(text.find(old), old.size(), by);
}

/// Returns what is wrong with an exercise of that text, from the file's name on; "" if nothing is.
std::string complaint(const std::string& text) {
    const Folder folder;
    const fs::path lesson = folder / "2-spheres";
    fs::create_directory(lesson);
    std::ofstream(lesson / "exercise.toml") << text;
    const std::string message = message_of<Error>([&] { read_exercise(lesson); });
    return message.substr(std::min(message.find("exercise.toml"), message.size()));
}

using Names = std::vector<std::string>;

CaseResult failing(const std::string& name, const std::string& expression, const std::string& got) {
    Failure failure;
    failure.expression = expression;
    failure.got = got;
    return {name, failure};
}

CaseResult not_written(const std::string& name, const std::string& function) {
    Failure failure;
    failure.threw = "`" + function + "` is not written yet (my/2-spheres/sphere.hpp:7)";
    return {name, failure, "", function};
}

}  // namespace

TEST_CASE("what is wrong with an exercise is told with its line and column") {
    CHECK(complaint(good) == "");
    CHECK(complaint(replaced(good, "stage = 2", "stage = 9")) ==
          "exercise.toml:7:9: error: stage is 9; it must be a whole number from 1 to 5");
    CHECK(complaint(replaced(good, "formula =", "formulas =")) ==
          "exercise.toml:13:1: error: unknown key 'formulas' in [[function]]; did you mean 'formula'?");
    CHECK(complaint(replaced(good, "header = \"sphere.hpp\"", "header = \"spere.hpp\"")) ==
          "exercise.toml:10:10: error: unknown header 'spere.hpp'; did you mean 'sphere.hpp'?");
    CHECK(complaint(replaced(good, "title = \"Spheres\"\n", "")).find("has no title; it needs one") !=
          std::string::npos);
    CHECK(complaint(replaced(good, "\"src/core/2-spheres\"", "\"../elsewhere\"")) ==
          "exercise.toml:3:8: error: core must be a path within the project, without '..'");
    CHECK(
        complaint(replaced(good, "tests = [\"the normal points\"]", "tests = []")).find("must be a list of strings") !=
        std::string::npos);
    CHECK(complaint("title = ").find("error: this is not TOML") != std::string::npos);
    CHECK(complaint(good.substr(0, good.find("[["))).find("has no [[function]]") != std::string::npos);
}

TEST_CASE("a mistake's place in the solution must be there, and there only once") {
    const Mistake mistake{"m", "x.hpp", "a + b", "a - b", "looks", {"mistakes.toml", 3, 8}};
    CHECK(with_mistake("return a + b;", mistake) == "return a - b;");
    CHECK(message_of<Error>([&] { with_mistake("return b;", mistake); }) ==
          "mistakes.toml:3:8: error: instead_of of mistake 'm' stands nowhere in the solution's x.hpp; it must stand "
          "there "
          "exactly once");
    CHECK(message_of<Error>([&] { with_mistake("a + b, a + b", mistake); }).find("more than once") !=
          std::string::npos);
}

TEST_CASE("gots are the same where the words are, and the numbers nearly") {
    CHECK(same_got("t: 0.5", "t: 0.5"));
    CHECK(same_got("t: 0.5", "t: 0.50000001"));
    CHECK_FALSE(same_got("t: 0.5", "t: 0.50001"));
    CHECK_FALSE(same_got("t: 0.5", "s: 0.5"));
    CHECK_FALSE(same_got("t: 0.5", "t: 0.5 0.5"));
    CHECK(same_got("(1, -2e+20, nan)", "(1, -2.0000001e20, nan)"));
    CHECK_FALSE(same_got("(1, 2, nan)", "(1, 2, inf)"));
    CHECK_FALSE(same_got("(1, 2, 3)", "(1, 2, inf)"));
    CHECK(same_got("", ""));
}

TEST_CASE(
    "a run may have a mistake if all that it fails fails here, with the same got; the one that shares most first") {
    const std::vector<Trace> known{{"small", "one", "f(): 3"},
                                   {"large", "one", "f(): 3"},
                                   {"large", "two", "g(): 4"},
                                   {"other", "one", "f(): 3"},
                                   {"other", "three", "h(): 5"}};
    TestRun run;
    run.cases = {failing("one", "f()", "3"), failing("two", "g()", "4 (0x1p+2)"), {"three"}};
    CHECK(candidates(run, known) == Names{"large", "small"});
    run.cases[1] = {"two"};
    CHECK(candidates(run, known) == Names{"small"});
    run.cases[0] = failing("one", "f()", "7");
    CHECK(candidates(run, known).empty());
    // what fails only because something is not written yet is no evidence for or against a mistake
    run.cases = {failing("one", "f()", "3"), not_written("two", "g"), {"three"}};
    CHECK(candidates(run, known) == Names{"large", "small"});  // by name
    run.cases = {not_written("one", "f"), not_written("two", "g"), {"three"}};
    CHECK(candidates(run, known).empty());
    // the same got is not enough where other checks of the case go otherwise
    run.cases = {failing("one", "f()", "3"), {"two"}, {"three"}};
    run.cases[0].checks = "+-";
    const std::vector<Trace> exactly{{"a", "one", "f(): 3", "+-"}, {"b", "one", "f(): 3", "--"}};
    CHECK(candidates(run, exactly) == Names{"a"});
}

TEST_CASE("a mistake is named only where it explains the failure that is shown, and all others of that function") {
    const Folder folder;
    const std::vector<Trace> known{{"down", "normal: up", "n: -1"},
                                   {"farthest", "nearest: of two", "t: 8"},
                                   {"farthest", "nearest: of three", "t: 9"},
                                   {"tie", "nearest: of equal ones", "t: 4"}};
    Exercise exercise;
    exercise.lesson = folder.path;
    exercise.headers = {"sphere.hpp"};
    exercise.functions = {{"nearest", "sphere.hpp", {"nearest:"}, {}}, {"normal", "sphere.hpp", {"normal:"}, {}}};
    std::ofstream(folder / "mistakes.json") << written(known);
    std::ofstream toml(folder / "mistakes.toml");
    for (const char* name : {"farthest", "down", "tie"})
        toml << "[[mistake]]\nname = '" << name << "'\nheader = 'sphere.hpp'\ninstead_of = 'a'\nwrites = 'b'\n"
             << "looks_like = 'It is " << name << ".'\n";
    toml.close();
    const auto told = [&](const TestRun& run) { return recognised(exercise, run, judged(exercise, run)); };
    const CaseResult two = failing("nearest: of two", "t", "8"), three = failing("nearest: of three", "t", "9"),
                     equal = failing("nearest: of equal ones", "t", "4"), up = failing("normal: up", "n", "-1");

    TestRun run;
    run.cases = {two, three, {"nearest: of equal ones"}, {"normal: up"}};
    CHECK(told(run).looks_like == "It is farthest.");
    CHECK(told(run).also.empty());
    // in another function
    run.cases[3] = up;
    CHECK(told(run).looks_like == "It is farthest.");
    CHECK(told(run).also_looks_like == "In `normal`: It is down.");
    // in the same
    run.cases = {two, three, equal, {"normal: up"}};
    CHECK(told(run).name == "farthest");
    CHECK(told(run).also_looks_like == "It is tie.");
    // a failure of the same function that nothing explains: then nothing is named there
    run.cases[2] = failing("nearest: of equal ones", "t", "5");
    CHECK(told(run).name.empty());
    run.cases[3] = up;
    CHECK(told(run).name.empty());
    CHECK(told(run).also_looks_like == "In `normal`: It is down.");
    // nor where the failure that is shown is not explained
    run.cases = {failing("nearest: of two", "t", "7"), three, {"nearest: of equal ones"}, {"normal: up"}};
    CHECK(told(run).name.empty());
    CHECK(told(run).also.empty());
}

TEST_CASE("a function that calls one that is not written waits for it, and has not failed") {
    Exercise exercise;
    exercise.functions = {{"roots", "", {"roots:"}, {}}, {"meet", "", {"meet:"}, {}}, {"normal", "", {"normal:"}, {}}};
    TestRun run;
    run.cases = {
        not_written("roots: two", "roots"), {"meet: none"}, not_written("meet: ahead", "roots"), {"normal: up"}};
    Judgement judgement = judged(exercise, run);
    CHECK(judgement.functions[0].state == State::not_written);
    CHECK(judgement.functions[1].state == State::waiting);
    CHECK(judgement.functions[1].waits_for == "roots");
    CHECK(judgement.functions[2].state == State::passed);
    CHECK(judgement.failed == 0);
    CHECK(judgement.waiting == 2);
    CHECK(judgement.function == &exercise.functions[0]);

    // what fails by itself has failed, whatever else is waiting
    run.cases[1] = failing("meet: none", "t", "3");
    judgement = judged(exercise, run);
    CHECK(judgement.functions[1].state == State::failing);
    CHECK(judgement.failed == 1);

    // a function that none of its own tests misses is the next to write if others wait for it
    run.cases = {{"roots: two"}, not_written("meet: ahead", "normal"), {"normal: up"}};
    judgement = judged(exercise, run);
    CHECK(judgement.function == &exercise.functions[2]);
    CHECK(judgement.shown == &run.cases[1]);

    LessonProgress progress;
    progress.functions = {{"roots", State::passed}, {"meet", State::waiting}, {"normal", State::not_written}};
    CHECK(open_function(exercise, progress) == &exercise.functions[2]);
    progress.functions["normal"] = State::passed;
    CHECK(open_function(exercise, progress) == &exercise.functions[1]);
    progress.functions["meet"] = State::passed;
    CHECK(open_function(exercise, progress) == nullptr);
}

TEST_CASE("a function is found by what its starter declares, though its name need not stand there") {
    const std::string starter =
        "struct Near {\n"
        "    Real operator()(Real a) const {\n"
        "        return not_written<Real>(\"Near\");\n"
        "    }\n"
        "};\n"
        "struct Far {\n"
        "    Real operator()(Real a) const {\n"
        "        const auto given = [&] { return a; };\n"
        "        return not_written<Real>(\"Far\");\n"
        "    }\n"
        "};\n"
        "\n"
        "/// The sum.\n"
        "template <class Real>\n"
        "Bounded operator+(Bounded a,\n"
        "                  Bounded b) {\n"
        "    // return not_written<Bounded>(\"Bounded + Bounded\");\n"
        "    return not_written<Bounded>(\"Bounded + Bounded\");\n"
        "}\n";
    CHECK(line_of_function(starter, starter, "Near") == 3);
    CHECK(line_of_function(starter, starter, "Far") == 9);
    CHECK(line_of_function(starter, starter, "Bounded + Bounded") == 18);
    CHECK(line_of_function(starter, starter, "Bounded") == 0);

    std::string written = "// mine\n" + starter;
    while (written.find("return not_written<") != std::string::npos)
        written = replaced(written, "return not_written<", "return the<");
    CHECK(line_of_function(written, starter, "Near") == 3);  // a line further down than in the starter
    CHECK(line_of_function(written, starter, "Far") == 8);
    CHECK(line_of_function(written, starter, "Bounded + Bounded") == 16);
    // however the declaration was changed, and whatever else is called
    const std::string changed =
        replaced(written, "    Real operator()(Real a) const", "constexpr auto operator()(auto b)");
    CHECK(line_of_function(changed, starter, "Near") == 3);
    CHECK(line_of_function(changed, starter, "Far") == 8);
    CHECK(line_of_function("Real x = operator+(a, b);\nreturn operator+(a, b);\nReal operator+(Real a) {\n", starter,
                           "Bounded + Bounded") == 3);
    CHECK(line_of_function("", starter, "Near") == 0);
    CHECK(line_of_function(written, "", "Near") == 0);
}

TEST_CASE("ulps are told of a number that is nearly right, and of no other") {
    const auto told = [](const char* expected, const char* got, const char* ulps) {
        Failure failure;
        failure.expected = expected;
        failure.got = got;
        failure.ulps = ulps;
        return ulps_text(failure);
    };
    CHECK(told("1 (0x1p+0)", "1.0000000000000007 (0x1.0000000000003p+0)", "3.000000") ==
          "3 ulps (units in the last place)");
    CHECK(told("-1", "-1.0000000000000002", "1.000000") == "1 ulp (unit in the last place)");
    // An error is rounded up: more than 4 must not look like 4.
    CHECK(told("1", "1.0000000000000009", "4.0000000000000009") == "4.01 ulps (units in the last place)");
    CHECK(told("5", "7", "2251799813685248.000000") == "");
    CHECK(told("5e-324", "-5e-324", "2.000000") == "");
    CHECK(told("1", "nan", "inf") == "");
    CHECK(told("true", "false", "") == "");
}

TEST_CASE("traces are written a line each, and read again") {
    const Folder folder;
    const std::vector<Trace> traces{{"a", "says \"x\"<double>", "f(): 3", "++-~"}, {"b", "two", "threw −1"}};
    std::ofstream(folder / "mistakes.json") << written(traces);
    CHECK(read_traces(folder / "mistakes.json") == traces);
    const std::string text = written(traces);
    CHECK(std::count(text.begin(), text.end(), '\n') == 4);
    CHECK(read_traces(folder / "none.json").empty());
    std::ofstream(folder / "mistakes.json") << "[{\"mistake\": 3}]";
    CHECK(message_of<Error>([&] { read_traces(folder / "mistakes.json"); }).find("--record") != std::string::npos);
}

TEST_CASE("a report is read up to where it ends; lines without the nonce are nobody's") {
    const auto line = [](const std::string& rest, const char* nonce = "n") {
        return std::string("{\"nonce\":\"") + nonce + "\"," + rest + "}\n";
    };
    const std::string two =
        line(R"("is":"case","name":"one")") + line(R"("is":"end","passed":true)") + line(R"("is":"case","name":"two")");
    Outcome ended, crashed;
    ended.end = End::exited;
    ended.last_words.kind = LastWords::finished;
    crashed.end = End::signal;
    crashed.status = SIGSEGV;

    const Report whole = read_report(two + line(R"("is":"end","passed":true)") + line(R"("is":"done")"), "n", ended);
    CHECK(whole.disturbed == "");
    REQUIRE(whole.cases.size() == 2);
    CHECK_FALSE(whole.cases[1].failure);

    const Report died = read_report(two, "n", crashed);
    REQUIRE(died.cases.size() == 2);
    REQUIRE(died.cases[1].failure);
    CHECK(died.cases[1].failure->died.find("memory that is not its own") != std::string::npos);

    const Report forged =
        read_report(two + line(R"("is":"end","passed":true)", "m") + line(R"("is":"done")", "m"), "n", ended);
    CHECK(forged.disturbed.find("something else than the tests") == 0);
    const Report garbage = read_report("\xff\xfe{{{\n" + two, "n", crashed);
    CHECK(garbage.cases.size() == 2);
    CHECK(read_report("", "n", crashed).cases.empty());
}

TEST_CASE("a failing scene has the test's ray, to the bit, at the pixel that is named") {
    Failure failure;
    const Folder folder;
    for (const double size : {0x1p-33, 0.1, 1.0, 0x1p33}) {
        CAPTURE(size);
        failure.ray = {-10 * size, 3 * size, size / 3, 1, 0.25, -1.0 / 3};
        for (const std::vector<double>& surface :
             {std::vector<double>{0, 0, 0, 5 * size}, std::vector<double>{size, 2 * size, 3 * size, 5 * size, -size,
                                                                          4 * size, 2 * size, 6 * size, -2 * size}}) {
            failure.surface = surface;
            const auto made = failing_scene("a \"test\"<double>", failure);
            REQUIRE(made);
            CHECK(made->toml.find("title = \"a 'test'\"\n") != std::string::npos);
            std::ofstream(folder / "failing.toml") << made->toml;
            const Scene scene = read_scene(folder / "failing.toml");
            CHECK(scene.spheres.size() + scene.triangles.size() == 1);
            const Ray<double> ray =
                pixel_ray(rebuilt_view(scene, {}), made->pixel.first, made->pixel.second, scene.height);
            CHECK(ray.P == Vec3<double>{failure.ray[0], failure.ray[1], failure.ray[2]});
            CHECK(ray.D == Vec3<double>{failure.ray[3], failure.ray[4], failure.ray[5]});
        }
    }
    failure.ray = {0, 0, 0, 0, 0, 0};
    CHECK_FALSE(failing_scene("a ray without a direction", failure));
    failure.ray.clear();
    CHECK_FALSE(failing_scene("no ray", failure));
}

TEST_CASE(
    "what was expected and got is told of a condition, too, by its two sides; an optional holds something or nothing") {
    const auto told = [](const char* expression, const char* got, bool negated) {
        Failure failure;
        failure.expression = expression;
        failure.got = got;
        failure.negated = negated;
        TestRun run;
        run.cases = {{"a test<double>", failure}};
        return first_wrong_text({}, {}, run, judged({}, run), {});
    };
    const auto has = [](const std::string& text, const char* rows) { return text.find(rows) != std::string::npos; };
    CHECK(has(told("best->surface == 5", "4 == 5", false), "expected  5\n  got       4\n"));
    CHECK(has(told("forwards", "{?}", false), "expected  something\n  got       nothing\n"));
    CHECK(has(told("nearest(Best{}, 0, miss)", "{?}", true), "expected  nothing\n  got       something\n"));
    // what cannot be shown, and a condition of another kind, is left as it is
    CHECK(has(told("a == b", "{?} == {?}", false), "got       {?} == {?}\n"));
    CHECK(has(told("crossed > 300", "20 > 300", false), "got       20 > 300\n"));
    CHECK_FALSE(has(told("crossed > 300", "20 > 300", false), "expected"));
}

TEST_CASE("where all is passed it is said how to see it, and where it is installed what the texts call otherwise") {
    const Folder folder;
    Workspace workspace = open_workspace(ROOT, folder / "my");
    fs::create_directories(workspace.hidden());
    Progress progress;
    for (const Exercise& exercise : workspace.exercises) progress.lessons[exercise.name].passed = true;
    write_progress(workspace.hidden() / "progress.json", progress);
    const auto status = [&] {
        Learner learner(workspace, [](const std::string&) {});
        return status_text(learner, {.width = 1000});
    };
    const std::string here = status();
    // the last lesson has no picture beside ours
    CHECK(here.find("All are passed. To see yours: ") != std::string::npos);
    CHECK(here.find("learn picture 7 -o picture.png") != std::string::npos);
    CHECK(here.find("In the texts") == std::string::npos);
    workspace.program = "glassbox";
    CHECK(status().find("In the texts `./glassbox` is `glassbox` here; what they call lessons/ and scenes/ lies in " +
                        shown(workspace.root) + ".\n") != std::string::npos);
    workspace.exercises.pop_back();
    CHECK(status().find("All are passed. To see yours beside ours: ") != std::string::npos);
    CHECK(status().find(" view --mine=6 --folder ") != std::string::npos);
}

TEST_CASE("progress is kept; a memory that cannot be read is set aside with a word, and nothing breaks") {
    const Folder folder;
    const fs::path file = folder / "progress.json";
    std::string complaint;
    CHECK(read_progress(file, complaint).lessons.empty());
    CHECK(complaint == "");
    Progress progress;
    progress.lessons["2-spheres"] = {true, true, 7, {{"normal", 2}}, {{"normal", State::failing}}, "abc"};
    write_progress(file, progress);
    const LessonProgress again = read_progress(file, complaint).lessons["2-spheres"];
    CHECK(complaint == "");
    CHECK(again.passed);
    CHECK(again.gave_up);
    CHECK(again.runs == 7);
    CHECK(again.hints.at("normal") == 2);
    CHECK(again.functions.at("normal") == State::failing);
    CHECK(again.tested == "abc");
    for (const char* broken : {"", "{", "[]", "{\"version\":1}", "{\"version\":\"x\",\"lessons\":{}}",
                               "{\"version\":9,\"lessons\":{}}", "{\"version\":1,\"lessons\":{\"a\":3}}", "\xff"}) {
        CAPTURE(std::string(broken));
        std::ofstream(file) << broken;
        complaint.clear();
        CHECK(read_progress(file, complaint).lessons.empty());
        CHECK(complaint.find("cannot be read") != std::string::npos);
        CHECK_FALSE(fs::exists(file));
        CHECK(content(folder / "progress.json.unreadable") == broken);
    }
}

TEST_CASE("a starter is cut from the solution: the body goes, and the comments that it begins with; the rest stays") {
    Exercise exercise;
    exercise.headers = {"sphere.hpp"};
    exercise.functions = {{.name = "normal",
                           .header = "sphere.hpp",
                           .tests = {},
                           .hints = {"", "", "const P q = p;\nreturn q;"},
                           .returns = "P",
                           .turn = "up",
                           .place = {"exercise.toml", 8, 1}}};
    const std::string solution =
        "#pragma once\n#include <cmath>\n\n#include <vec3.hpp>\n\n/// Up.\nP normal(P p) {\n    // why\n    const P q "
        "= p;  // so\n"
        "    // and\n    return q;\n}\n";
    CHECK(starter_from(solution, exercise, "sphere.hpp") ==
          "#pragma once\n#include <cmath>\n\n#include <not_written.hpp>\n#include <vec3.hpp>\n\n/// Up.\nP normal(P p) "
          "{\n"
          "    // Your turn: up\n    return not_written<P>(\"normal\");\n}\n");
    const std::string without = "P normal(P p) {\n    return p;\n}\n";
    CHECK(message_of<Error>([&] {
              starter_from(without, exercise, "sphere.hpp");
          }).find("exercise.toml:8:1: error: the line of normal is not its body in sphere.hpp") != std::string::npos);
}

TEST_CASE("starters are made once; what a learner wrote is never lost") {
    const Folder folder;
    const Workspace workspace = open_workspace(ROOT, folder / "my");
    CHECK(workspace.root == ROOT);
    const Exercise& exercise = exercise_called(workspace, "spheres");
    CHECK(&exercise == &exercise_called(workspace, "2"));
    CHECK(message_of<Error>([&] { exercise_called(workspace, "sphears"); }).find("did you mean 'spheres'?") !=
          std::string::npos);
    CHECK(make_starters(workspace, exercise));
    CHECK_FALSE(make_starters(workspace, exercise));
    const fs::path header = workspace.header(exercise, "sphere.hpp");
    CHECK(content(header) == workspace.starter(exercise, "sphere.hpp"));
    CHECK(reset(workspace, exercise).empty());  // nothing was changed
    std::ofstream(header) << "first";
    CHECK(reset(workspace, exercise) == std::vector<fs::path>{header.string() + ".1"});
    std::ofstream(header) << "second";
    CHECK(reset(workspace, exercise) == std::vector<fs::path>{header.string() + ".2"});
    CHECK(content(header.string() + ".1") == "first");
    CHECK(content(header.string() + ".2") == "second");
    CHECK(content(header) == workspace.starter(exercise, "sphere.hpp"));
}

TEST_CASE(
    "a change is noticed, a touch is not; a file that is gone for a moment or written in two steps is one change") {
    const Folder folder;
    std::ofstream(folder / "vec3.hpp") << "one";
    Watch watch(folder.path);
    std::stop_source stop;
    std::jthread edits([&] {
        std::this_thread::sleep_for(150ms);
        fs::last_write_time(folder / "vec3.hpp", fs::file_time_type::clock::now());
        std::this_thread::sleep_for(300ms);
        fs::remove(folder / "vec3.hpp");
        std::ofstream file(folder / "vec3.hpp");
        file << "tw" << std::flush;
        std::this_thread::sleep_for(10ms);
        file << "o" << std::flush;
    });
    const auto start = std::chrono::steady_clock::now();
    CHECK(watch.wait(stop.get_token()));
    CHECK(std::chrono::steady_clock::now() - start > 400ms);  // not when it was only touched
    edits.join();
    stop.request_stop();
    CHECK_FALSE(watch.wait(stop.get_token()));
}
