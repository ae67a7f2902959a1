// What a learner's header may do when it runs, and when it is compiled: `learn` says what happened and where, and
// leaves no process running. There is no real fork bomb: where tests run as root, no limit would stop it.
#include <doctest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <span>
#include <thread>

#include "learn/check/judgement.hpp"
#include "learn/learner.hpp"
#include "learn/prepared.hpp"
#include "learn/telling.hpp"
#include "output/folder.hpp"
#include "scene/text_file.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using glassbox::test::Folder;
using glassbox::test::message_of;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

/// A learner's folder, shared by all cases, so that the toolchain is made only once.
class Victim {
public:
    Victim()
        : learner_(open_workspace(ROOT, folder_.path), [](const std::string&) {}), exercise_(learner_.lesson("1")) {}

    const Workspace& workspace() const { return learner_.workspace(); }
    const Exercise& exercise() const { return exercise_; }
    Learner& learner() { return learner_; }
    fs::path header() const { return workspace().header(exercise_, "vec3.hpp"); }

    /// The solution, with another text as the body of `dot`.
    std::string with_body(const std::string& body) const {
        return changed("return a.x * b.x + a.y * b.y + a.z * b.z;", body);
    }

    /// The solution, with one part of it replaced.
    std::string changed(const std::string& old, const std::string& text) const {
        std::string solution = read_text(workspace().solution(exercise_, "vec3.hpp"));
        solution.replace(solution.find(old), old.size(), text);
        return solution;
    }

    /// Tests that text as vec3.hpp; returns what a learner reads.
    std::string told(const std::string& text, std::chrono::milliseconds deadline = 5s) {
        make_starters(workspace(), exercise_);
        for (const std::string& header : exercise_.headers)
            fs::copy_file(workspace().solution(exercise_, header), workspace().header(exercise_, header),
                          fs::copy_options::overwrite_existing);
        std::ofstream(header(), std::ios::binary) << text;
        const fs::path folder = workspace().hidden() / exercise_.name;
        fs::create_directories(folder);
        TestedLesson tested;
        tested.run = run_tests(workspace(), exercise_, learner_.tools(),
                               {workspace().headers_of(exercise_), folder, false, deadline});
        tested.judgement = judged(exercise_, tested.run);
        CHECK_FALSE(tested.run.passed());
        return tested_text(learner_, exercise_, tested, Paint{});
    }

    /// Returns how many processes run this learner's program. Killed ones may need a moment.
    int running() const {
        int count = running_now();
        for (int looks = 0; count > 0 && looks < 100; ++looks) {
            std::this_thread::sleep_for(20ms);
            count = running_now();
        }
        return count;
    }

private:
    int running_now() const {
        int count = 0;
        std::error_code gone;
        for (const fs::directory_entry& process : fs::directory_iterator("/proc", gone)) {
            const fs::path program = fs::read_symlink(process.path() / "exe", gone);
            if (!gone && program.string().starts_with(folder_.path.string())) ++count;
        }
        return count;
    }

    Folder folder_;
    glassbox::test::Prepared prepared_{folder_ / ".glassbox"};
    Learner learner_;
    const Exercise& exercise_;
};

Victim& victim() {
    static Victim one;
    return one;
}

/// Sets an environment variable during its lifetime; child processes inherit it.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) { ::setenv(name, value.c_str(), 1); }
    ~Variable() { ::unsetenv(name_); }

private:
    const char* name_;
};

/// Everything that `dot` can do when called: one program, compiled once, can do each of them.
constexpr const char* everything = R"(
    const std::string kind = std::getenv("GLASSBOX_HOSTILE");
    static volatile int zero = 0;
    if (kind == "null pointer") *static_cast<volatile int*>(nullptr) = 1;
    if (kind == "stack overflow") return dot(a, b) + Real(1);
    if (kind == "endless loop") for (volatile int i = 0;; i = i + 1) {}
    if (kind == "endless output") for (;;) std::printf("and on and on and on and on and on and on and on and on\n");
    if (kind == "exit") std::exit(0);
    if (kind == "quick exit") ::_exit(0);
    if (kind == "abort") std::abort();
    if (kind == "exception") throw std::runtime_error("I give up");
    if (kind == "thrown number") throw 42;
    if (kind == "division by zero") return Real(7 % zero);
    if (kind == "not a number") return std::numeric_limits<Real>::quiet_NaN();
    if (kind == "memory") for (std::size_t n = 1 << 26;; n *= 2) zero = *static_cast<volatile char*>(::operator new(n));
    if (kind == "children") {
        for (int i = 0; i < 20; ++i) if (::fork() == 0) for (;;) ::pause();
        for (;;) ::pause();
    }
    if (kind == "closed outputs") for (int i = 0; i < 3; ++i) ::close(i);
    if (kind == "signal") ::kill(::getpid(), SIGKILL);
    if (kind == "false report") {
        std::FILE* report = std::fopen("double-report", "a");
        std::fputs("{\"nonce\":\"\",\"is\":\"end\",\"passed\":true}\n{\"nonce\":\"\",\"is\":\"done\"}\n", report);
        std::fclose(report);
    }
    if (kind == "false report and exit") {
        std::FILE* report = std::fopen("double-report", "w");
        std::fputs("{\"nonce\":\"\",\"is\":\"done\"}\n", report);
        std::fclose(report);
        ::_exit(0);
    }
    return a.x * b.x + a.y * b.y + a.z * b.z;)";

void check_has(const std::string& text, const std::string& part) {
    CHECK_MESSAGE(text.find(part) != std::string::npos, "'", part, "' should be in:\n", text);
}

}  // namespace

TEST_CASE("whatever a learner's function does, it is told in words, with the function and its place") {
    const std::string all =
        "#include <signal.h>\n#include <unistd.h>\n#include <cstdio>\n#include <cstdlib>\n"
        "#include <cstring>\n#include <string>\n";
    std::string text = victim().with_body(everything);
    text.insert(text.find("#include"), all);
    text.erase(text.find("constexpr Real dot"), std::string("constexpr ").size());

    struct Case {
        std::string kind, words;
    };
    for (const Case& one : {
             Case{"null pointer", "it followed a null pointer"},
             Case{"stack overflow", "its stack overflowed: a function that calls itself without end?"},
             Case{"endless loop", "without ending: an endless loop?"},
             Case{"endless output", "without ending: an endless loop that prints?"},
             Case{"exit", "it called exit(0) before its work was done"},
             Case{"quick exit", "it ended the program (by _exit, perhaps)"},
             Case{"abort", "it gave up (abort)"},
             Case{"exception", "I give up"},
             Case{"thrown number", "unknown exception"},
             Case{"division by zero", "it divided a whole number by zero"},
             Case{"not a number", "nan"},
             Case{"memory", "bad_alloc"},
             Case{"children", "without ending"},
             Case{"signal", "memory"},
         }) {
        CAPTURE(one.kind);
        const Variable variable("GLASSBOX_HOSTILE", one.kind);
        const std::string told = victim().told(text, 700ms);
        check_has(told, one.words);
        check_has(told, "dot in ");
        check_has(told, "1-rays/vec3.hpp:");
        check_has(told, "a.b adds up the products of the components");
        CHECK(victim().running() == 0);
    }
}

TEST_CASE("outputs that are closed, and lines in the report that are not the tests', change no result") {
    const std::string all =
        "#include <unistd.h>\n#include <cstdio>\n#include <cstring>\n#include <cstdlib>\n"
        "#include <signal.h>\n#include <string>\n";
    std::string text = victim().with_body(everything);
    text.insert(text.find("#include"), all);
    text.erase(text.find("constexpr Real dot"), std::string("constexpr ").size());
    // One mistake elsewhere, so that the tests fail as they should
    const std::string good = "return a / length(a);";
    text.replace(text.find(good), good.size(), "return a;");
    {
        const Variable variable("GLASSBOX_HOSTILE", "closed outputs");
        check_has(victim().told(text), "✗ unit in ");
    }
    for (const char* kind : {"false report", "false report and exit"}) {
        const Variable variable("GLASSBOX_HOSTILE", kind);
        check_has(victim().told(text), "something else than the tests wrote into their report");
    }
}

TEST_CASE("a header that does not compile is told of once, at its first error, in plain words") {
    struct Case {
        std::string what, text;
        std::vector<std::string> words;
    };
    std::string hundred = victim().changed("}  // namespace glassbox", "");
    for (int i = 0; i < 100; ++i) hundred += "int broken" + std::to_string(i) + "( { return nothing there; ]\n";
    const std::string deep =
        "template <int n>\nstruct Deep {\n    static constexpr int value = Deep<n + 1>::value;\n};\n"
        "constexpr int deep = Deep<0>::value;\n\n}  // namespace glassbox";
    for (const Case& one : {
             Case{"a hundred errors", hundred, {"1-rays/vec3.hpp:", "this does not compile", "more error"}},
             Case{
                 "a missing semicolon", victim().with_body("return a.x"), {"vec3.hpp:45:15", "A semicolon is missing"}},
             Case{"a name that is not there",
                  victim().changed("sqrt(dot(a, a))", "sqrt(dto(a, a))"),
                  {"Nothing is called dto here; did you mean 'dot'?", "return sqrt(dto(a, a));"}},
             Case{"no return",
                  victim().changed("return a / length(a);", "a / length(a);"),
                  {"comes to its end without 'return'"}},
             Case{"a later stage",
                  victim().changed("#include <cmath>", "#include <triangle.hpp>"),
                  {"vec3.hpp:2:10", "triangle.hpp belongs to lesson 3-triangles"}},
             Case{"templates without end",
                  victim().changed("}  // namespace glassbox", deep),
                  {"vec3.hpp:", "A template needs itself without end"}},
             Case{"an include of itself",
                  victim().changed("#pragma once", "#include \"vec3.hpp\""),
                  {"vec3.hpp:1:", "The file includes itself"}},
             // clang++ reads it as an empty file, g++ reads until its memory is used up
             Case{"an include without end",
                  victim().changed("#include <cmath>", "#include \"/dev/zero\"\nint oops"),
                  {"not compile"}},
             Case{"another thing altogether", std::string(100, '\x01') + "%PDF-1.5", {"vec3.hpp:1:1"}},
             Case{"nothing", "", {"Vec3"}},
         }) {
        CAPTURE(one.what);
        const std::string told = victim().told(one.text);
        for (const std::string& part : one.words) check_has(told, part);
        check_has(told, "compile");
        CHECK(told.find("\x1b") == std::string::npos);
        CHECK(victim().running() == 0);
    }
}

TEST_CASE("what a learner writes commands no terminal: a line of source, an exception") {
    const std::string commands =
        "\x1b]0;mine\x07\x1b[2J\xC2\x9B"
        "31m\x9B"
        "1m\x7F\xE2\x80\xAE";
    std::string throwing = victim().with_body("throw std::runtime_error(\"now: " + commands + "\");");
    throwing.insert(throwing.find("#include"), "#include <stdexcept>\n");
    throwing.erase(throwing.find("constexpr Real dot"), std::string("constexpr ").size());
    for (const std::string& text : {throwing, victim().with_body("return nothing; /* now: " + commands + " */")}) {
        const std::string told = victim().told(text);
        check_has(told, "now: ?]0;mine??[2J?31m?1m??");
        for (const char* part : {"\x1b", "\x07", "\xC2\x9B", "\x9B", "\x7F", "\xE2\x80\xAE"})
            CHECK(told.find(part) == std::string::npos);
    }
}

TEST_CASE("what is taken away while one works is made anew") {
    make_starters(victim().workspace(), victim().exercise());
    reset(victim().workspace(), victim().exercise());
    const auto not_written = [] {
        return victim().learner().test(victim().exercise()).judgement.shown->failure->not_written();
    };
    CHECK(not_written() == "dot");
    fs::remove_all(victim().workspace().hidden());
    CHECK(not_written() == "dot");
    fs::remove_all(victim().learner().tools().prelude.parent_path());
    CHECK(not_written() == "dot");
}

TEST_CASE("a header that is not there, or is no file, is refused with a way out") {
    make_starters(victim().workspace(), victim().exercise());
    for (const std::string& name : victim().exercise().headers)
        fs::copy_file(victim().workspace().solution(victim().exercise(), name),
                      victim().workspace().header(victim().exercise(), name), fs::copy_options::overwrite_existing);
    const fs::path header = victim().header();
    const auto refusal = [&] { return message_of<Error>([] { victim().learner().test(victim().exercise()); }); };
    fs::remove(header);
    check_has(refusal(), "vec3.hpp: error: there is no such file: was it deleted, or renamed?");
    check_has(refusal(), "learn reset 1");
    fs::create_directory(header);
    check_has(refusal(), "this is not a plain file");
    fs::remove(header);
    REQUIRE(::mkfifo(header.c_str(), 0600) == 0);
    check_has(refusal(), "this is not a plain file");
    fs::remove(header);
    fs::create_symlink("/dev/zero", header);
    check_has(refusal(), "this is not a plain file");
    fs::remove(header);
    std::ofstream(header, std::ios::binary) << std::string(100, '\0');
    check_has(refusal(), "this is a binary file");
    fs::remove(header);
    std::ofstream(header) << "x";
    fs::resize_file(header, std::uintmax_t{1} << 40);  // a sparse file of a terabyte
    check_has(refusal(), "is larger than 4 MiB");
    CHECK(reset(victim().workspace(), victim().exercise()).size() == 3);  // the other two are solutions until then
    CHECK(refusal() == "");
    CHECK(fs::exists(header.string() + ".1"));
}
