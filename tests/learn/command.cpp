// `glassbox learn` as a learner runs it, without a terminal.
#include <doctest.h>

#include <cstdlib>
#include <fstream>

#include "cli/program.hpp"
#include "learn/prepared.hpp"

using namespace glassbox::test;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// One folder for all cases, so that the toolchain is made only once.
const Folder& home() {
    static Folder folder;
    static Prepared prepared(folder / "mine/.glassbox");
    return folder;
}

Ran learn(Arguments arguments) {
    arguments.insert(arguments.begin(), "learn");
    arguments.insert(arguments.end(), {"--folder", "mine"});
    return run_glassbox(arguments, {.folder = home().path});
}

void check_has(const std::string& text, const std::string& part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, "'", part, "' should be in:\n", text);
}

}  // namespace

TEST_CASE("learn shows where one is, and makes the first starter") {
    const Ran ran = learn({});
    CHECK(ran.status == 0);
    check_has(ran.out, "1 Rays");
    check_has(ran.out, "0 of 9 functions");
    check_has(ran.out, "lessons/1-rays/README.md");
    check_has(ran.out, "write   dot in mine/1-rays/vec3.hpp:");
    CHECK(ran.out.find('\x1b') == std::string::npos);
    CHECK(fs::exists(home() / "mine/1-rays/vec3.hpp"));
}

TEST_CASE("what is not written yet is what to write next; hints come in three tiers, and the last one stays") {
    const Ran tested = learn({"test", "1"});
    CHECK(tested.status == 1);
    check_has(tested.out, "Next to write: dot in mine/1-rays/vec3.hpp:");
    check_has(learn({"hint", "1"}).out, "A question (hint 1 of 3)");
    check_has(learn({"hint"}).out, "The formula (hint 2 of 3)");
    check_has(learn({"hint", "rays"}).out, "return a.x * b.x + a.y * b.y + a.z * b.z;");
    check_has(learn({"hint", "1-rays"}).out, "hint 3 of 3");
    check_has(learn({"status"}).out, "3 hints");
}

TEST_CASE("a classic mistake is told with its test, its numbers and its name's words; what was there is kept") {
    const Ran made = learn({"mistake", "2", "far-root-missing"});
    CHECK(made.status == 0);
    check_has(made.out, "Kept: mine/2-spheres/crossing.hpp.1");
    const Ran ran = learn({"test", "2"});
    CHECK(ran.status == 1);
    check_has(ran.out, "✗ first_ahead in mine/2-spheres/crossing.hpp:");
    check_has(ran.out, "expected");
    check_has(ran.out, "This looks familiar.");
    CHECK(ran.out.find("Look at this ray") == std::string::npos);  // the check that is shown has two numbers and no ray
    const std::string list = learn({"mistake", "2"}).out;
    check_has(list, "\nnormal-inwards ");
    CHECK(list.find("\n ") == std::string::npos);  // in a pipe each has one line, however long
}

TEST_CASE("what only waits for a function to be written is told to wait, and is not marked as wrong") {
    learn({"reset", "1"});
    for (const char* header : {"vec3.hpp", "ray.hpp", "viewing_plane.hpp"}) {
        std::string solution = content(fs::path(ROOT) / "src/core/1-rays" / header);
        const std::string dot = "return a.x * b.x + a.y * b.y + a.z * b.z;";
        if (const std::size_t at = solution.find(dot); at != std::string::npos)
            solution.replace(at, dot.size(), "return not_written<Real>(\"dot\");")
                .insert(solution.find("#include"), "#include <not_written.hpp>\n");
        std::ofstream(home() / "mine/1-rays" / header) << solution;
    }
    const Ran ran = learn({"test", "1"});
    CHECK(ran.status == 1);
    check_has(ran.out, "· dot");
    check_has(ran.out, "… cross, length, unit wait for `dot`");
    check_has(ran.out, "✓ at");
    check_has(ran.out, "Next to write: dot in mine/1-rays/vec3.hpp:");
    CHECK(ran.out.find("✗") == std::string::npos);
    check_has(learn({"status"}).out, "write   dot in mine/1-rays/vec3.hpp:");
}

TEST_CASE("tests that do not compile with our own headers, either, are not blamed on the learner") {
    const Folder project;
    for (const char* same : {"lessons", "src"}) fs::create_directory_symlink(fs::path(ROOT) / same, project / same);
    fs::create_directory(project / "tests");
    for (const char* copied : {"tests/stages", "tests/support"}) fs::copy(fs::path(ROOT) / copied, project / copied);
    std::ofstream(project / "tests/stages/stage1_rays.cpp", std::ios::app) << "static_assert(renamed_since);\n";
    const Ran ran = run_glassbox({"learn", "test", "1", "--folder", "mine"}, {.folder = project.path});
    CHECK(ran.status == 1);
    check_has(ran.out, "tests/stages/stage1_rays.cpp:");
    check_has(ran.out, "This is no mistake of yours: with our own headers it is the same. Run ./glassbox");
    CHECK(ran.out.find("your headers") == std::string::npos);
}

TEST_CASE("the solution can be piped, passes, and makes a picture; that one gave up is remembered") {
    const Ran solution = learn({"solution", "4"});
    CHECK(solution.status == 0);
    check_has(solution.err, "reflection.hpp");
    CHECK(solution.out == content(fs::path(ROOT) / "src/core/4-shading/reflection.hpp"));
    learn({"reset", "4"});
    std::ofstream(home() / "mine/4-shading/reflection.hpp") << solution.out;
    const Ran tested = learn({"test", "4"});
    CHECK(tested.status == 0);
    check_has(tested.out, "of lesson 4 pass");
    check_has(learn({"status"}).out, "passed, the solution was shown");
    const Ran picture = learn({"picture", "2", "--mistake", "nearest-is-farthest", "-o", "wrong.png"});
    CHECK(picture.status == 0);
    CHECK(content(home() / "wrong.png").starts_with("\x89PNG"));
    check_has(picture.out, "wrong.png is written: ");
    check_has(picture.out, "the picture of lesson 2 with the mistake nearest-is-farthest");
    const Ran none = learn({"picture", "6", "-o", "none.png"});
    CHECK(none.status == 1);
    check_has(none.err, "is not written yet");
    CHECK_FALSE(fs::exists(home() / "none.png"));
}

TEST_CASE("a picture has a part for each step: what is not written yet leaves its parts striped, and is named once") {
    const Ran picture =
        run_glassbox({"learn", "picture", "2", "--folder", "begun", "-o", "begun.png"}, {.folder = home().path});
    CHECK(picture.status == 0);
    CHECK(content(home() / "begun.png").starts_with("\x89PNG"));
    const std::string missing = "striped in the picture: `quadratic` is not written yet (";
    const std::size_t first = picture.err.find(missing);
    REQUIRE(first != std::string::npos);
    CHECK(picture.err.find(missing, first + 1) == std::string::npos);  // two parts need it
}

TEST_CASE("a lesson that is reset stands as one that is not begun") {
    learn({"reset", "4"});
    const std::string status = learn({"status"}).out;
    check_has(status, "4 Shading    ░░░░░░░░░░░░  0 of 6 functions, the solution was shown");
}

TEST_CASE("what no mistake explains is described, with the inputs of the check, and by the rule that is tested") {
    learn({"reset", "2"});
    for (const char* header : {"crossing.hpp", "sphere.hpp", "chord.hpp"})
        fs::copy_file(fs::path(ROOT) / "src/core/2-spheres" / header, home() / "mine/2-spheres" / header,
                      fs::copy_options::overwrite_existing);
    std::string solution = content(fs::path(ROOT) / "src/core/2-spheres/quadratic.hpp");
    // D made a unit vector: a and b are wrong where D is longer, c does not know D
    const std::string direction = "const Vec3<Real> D = ray.D;";
    REQUIRE(solution.find(direction) != std::string::npos);
    solution.replace(solution.find(direction), direction.size(), "const Vec3<Real> D = unit(ray.D);");
    std::ofstream(home() / "mine/2-spheres/quadratic.hpp") << solution;
    const Ran ran = learn({"test", "2"});
    CHECK(ran.status == 1);
    check_has(ran.out, "✗ quadratic in mine/2-spheres/quadratic.hpp:");
    check_has(ran.out, "ray       P = (-10, 3, 0), D = (2, 0, 0)\n");
    check_has(ran.out, "sphere    C = (0, 0, 0), r = 5\n");
    // a and b of two rays with |D| = 2 and 3; their c, and b and c of a third with |D| = 1, are right
    check_has(ran.out, "What the checks show: 4 of 8 checks of `quadratic` fail.");
    check_has(ran.out, "view mine/.glassbox/failing.toml --pixel ");
    check_has(ran.out, " --sphere textbook --mine=2 --folder mine\n");
    CHECK(content(home() / "mine/.glassbox/failing.toml").find("<double>") == std::string::npos);
    CHECK(ran.out.find("This looks familiar.") == std::string::npos);
}

TEST_CASE(
    "a report leaves out what is no folder, finds lessons further in, and does not take ours for a missing header") {
    const fs::path hand = home() / "hand", rays = fs::path(ROOT) / "src/core/1-rays";
    for (const char* folder : {"ada/1-Rays", "bo/my/1-rays"}) {
        fs::create_directories(hand / folder);
        for (const char* header : {"vec3.hpp", "ray.hpp", "viewing_plane.hpp"})
            fs::copy_file(rays / header, hand / folder / header);
    }
    fs::remove(hand / "bo/my/1-rays/vec3.hpp");
    std::ofstream(hand / "notes.txt") << "x\n";
    const Ran ran = learn({"report", "hand/ada", "hand/bo", "hand/notes.txt", "-o", "class.csv"});
    CHECK(ran.status == 0);
    check_has(ran.err, "hand/notes.txt: note: this is no folder; it is left out");
    check_has(ran.err, "hand/bo: note: its lessons are in hand/bo/my");
    const std::string csv = content(home() / "class.csv");
    check_has(csv, "\nada,1,passed,9,9,");
    check_has(csv, "\nbo,1,does not compile,0,9,0,0,0,");
    const Ran page = learn({"report", "hand/bo", "-o", "bo.html"});
    check_has(content(home() / "bo.html"), "its lessons are in hand/bo/my");
    check_has(content(home() / "bo.html"), "vec3.hpp: error: there is no such file");
    const Ran none = learn({"report", "hand/ada", "hand/nobody"});
    CHECK(none.status == 1);
    check_has(none.err, "hand/nobody: error: there is no such folder");
    CHECK(none.seconds < 5);
}

TEST_CASE("watch says what it watches and ends with Ctrl-C, in the middle of a test, too") {
    for (const auto at : {300ms, 6000ms}) {
        const Ran ran =
            run_glassbox({"learn", "watch", "6", "--folder", "mine"}, {.folder = home().path, .signal_at = at});
        CHECK(ran.seconds < 2);
        CHECK((ran.status == 0 || ran.status == 130));
        CHECK(ran.out.find('\x1b') == std::string::npos);
        if (at > 1s) check_has(ran.out, "Watching mine/6-rounding; save a file to test again, Ctrl-C to end.");
    }
}

TEST_CASE("a bad command line is refused in the words of the command that it names") {
    check_refused(home(), {"learn", "tets", "1"}, 2,
                  {"glassbox learn: error: 'tets' is no command; did you mean 'test'?"});
    check_refused(home(), {"learn", "test", "1", "2"}, 2, {"glassbox learn test: error: '2' is one word too many"});
    check_refused(home(), {"learn", "picture", "1"}, 2, {"glassbox learn picture: error: --out is missing"});
    check_refused(home(), {"learn", "test", "nine"}, 1, {"there is no lesson 'nine'"});
    check_refused(home(), {"learn", "mistake", "1", "croos-swapped"}, 1, {"did you mean 'cross-swapped'?"});
    check_refused(home(), {"view", "--mine=7"}, 2,
                  {"--mine: no picture beside ours is made by what lesson 7 teaches", "glassbox learn picture 7"});
}

TEST_CASE("a compiler that is not there is asked for by name") {
    ::setenv("CXX", "no-such-compiler", 1);
    const Ran ran = learn({"test", "1"});
    ::unsetenv("CXX");
    CHECK(ran.status == 1);
    check_has(ran.err, "the compiler 'no-such-compiler' does not answer");
    check_has(ran.err, "install g++");
}
