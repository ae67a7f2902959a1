// Strangers' code runs isolated, where bubblewrap can do that, and is graded as usual. Each attack is made without
// isolation first: there it must succeed, or the test would prove nothing.
#include "learn/subprocess/isolation.hpp"

#include <arpa/inet.h>
#include <doctest.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "learn/check/judgement.hpp"
#include "learn/check/test_run.hpp"
#include "learn/prepared.hpp"
#include "learn/report/grade.hpp"
#include "learn/telling.hpp"
#include "output/folder.hpp"
#include "scene/text_file.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using glassbox::test::content;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

extern char** environ;

namespace {

/// Whether these tests cannot run here; reports that, and ctest counts them as skipped.
bool is_skipped() {
    static const std::string why = why_not_isolated();
    if (!why.empty()) MESSAGE("skipped: ", why);
    return !why.empty();
}

/// Sets an environment variable during its lifetime.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (before_) ::setenv(name_, before_->c_str(), 1);
        else ::unsetenv(name_);
    }

private:
    const char* name_;
    std::optional<std::string> before_;
};

/// A server on 127.0.0.1 that accepts connections.
class Listener {
public:
    Listener() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        REQUIRE(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size) == 0);
        REQUIRE(::listen(socket_, 8) == 0);
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
        port = ntohs(address.sin_port);
    }
    ~Listener() { ::close(socket_); }
    int port = 0;

private:
    int socket_;
};

/// A process of ours that does nothing, and could be ended by our other processes.
class Bystander {
public:
    Bystander() {
        char name[] = "sleep", time[] = "600";
        char* arguments[] = {name, time, nullptr};
        REQUIRE(::posix_spawnp(&number, "sleep", nullptr, nullptr, arguments, environ) == 0);
    }
    ~Bystander() {
        ::kill(number, SIGKILL);
        ::waitpid(number, nullptr, 0);
    }
    bool lives() const { return ::waitpid(number, nullptr, WNOHANG) == 0; }
    pid_t number = 0;
};

/// A teacher's machine: a home folder with the course, and lesson 1 handed in by two learners.
struct Machine {
    fs::path home = new_folder(fs::path(FOLDER) / "isolation-home");
    Variable home_variable{"HOME", home.string()};
    Variable secret{"GLASSBOX_TEST_SECRET", "a password"};
    fs::path outside = new_folder(fs::path(FOLDER) / "isolation-outside");
    Listener listener;
    Bystander bystander;
    Workspace teacher = open_workspace(ROOT, home / "course" / "my");
    glassbox::test::Prepared prepared{teacher.hidden()};
    fs::path ada = home / "course/handed-in/ada", bo = home / "course/handed-in/bo";

    Machine() {
        fs::create_directories(home / ".ssh");
        std::ofstream(home / ".ssh/id") << "a key\n";
        for (const fs::path& learner : {ada, bo}) write(learner, solution());
    }
    ~Machine() {
        for (const fs::path& folder : {home, outside}) fs::remove_all(folder);
    }

    std::string solution() const { return read_text(teacher.solution(rays(), "vec3.hpp")); }
    const Exercise& rays() const { return exercise_called(teacher, "1"); }
    void write(const fs::path& learner, const std::string& vec3) const {
        fs::create_directories(learner / "1-rays");
        for (const std::string& header : rays().headers)
            fs::copy_file(teacher.solution(rays(), header), learner / "1-rays" / header,
                          fs::copy_options::overwrite_existing);
        std::ofstream(learner / "1-rays/vec3.hpp") << vec3;
    }

    /// The solution, whose dot() first does something else.
    std::string with_deed(const std::string& deed) const {
        std::string text = solution();
        const std::string body = "return a.x * b.x + a.y * b.y + a.z * b.z;";
        text.insert(text.find(body), "deed();\n    ");
        text.erase(text.find("constexpr Real dot"), std::string("constexpr ").size());
        text.insert(text.find("namespace glassbox {"),
                    "#include <arpa/inet.h>\n#include <netinet/in.h>\n"
                    "#include <signal.h>\n#include <sys/socket.h>\n"
                    "#include <unistd.h>\n#include <cstdlib>\n#include <fstream>\n"
                    "#include <stdexcept>\n#include <string>\n" +
                        deed);
        return text;
    }

    /// Everything that a stranger might try; reports success by an exception, except for writes: those leave a file, or
    /// not.
    std::string attack() const {
        return fmt::format(
            R"(inline bool reads(const char* file) {{ return static_cast<bool>(std::ifstream(file)); }}
inline void write(const char* file) {{ std::ofstream(file, std::ios::app) << "x"; }}
inline bool connects() {{
    sockaddr_in address{{}};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons({port});
    const int one = ::socket(AF_INET, SOCK_STREAM, 0);
    const bool is_done = ::connect(one, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
    ::close(one);
    return is_done;
}}
#if __has_include("{home}/.ssh/id")
constexpr bool includes = true;
#else
constexpr bool includes = false;
#endif
inline std::string what_is_possible() {{
    std::string done;
    if (reads("{home}/.ssh/id")) done += " home-read";
    if (includes) done += " home-included";
    write("{home}/.profile");
    write("{outside}/file");
    write("{ada}/1-rays/ray.hpp");
    if (reads("{bo}/1-rays/vec3.hpp")) done += " neighbour-read";
    if (connects()) done += " connected";
    if (std::getenv("GLASSBOX_TEST_SECRET")) done += " environment-read";
    if (::kill({process}, 0) == 0) done += " process-found";
    return done;
}}
inline void deed() {{
    static const std::string done = what_is_possible();
    if (!done.empty()) throw std::runtime_error("done:" + done);
}}
)",
            fmt::arg("port", listener.port), fmt::arg("home", home.string()), fmt::arg("outside", outside.string()),
            fmt::arg("ada", ada.string()), fmt::arg("bo", bo.string()), fmt::arg("process", bystander.number));
    }
};

const auto nothing = [](const std::string&) {};

Command of_child(const std::string& kind, bool is_isolated, const std::vector<std::string>& more = {}) {
    Command command{CHILD_PROGRAM, {kind}};
    command.arguments.insert(command.arguments.end(), more.begin(), more.end());
    command.limits.time = 10s;
    if (is_isolated) command.isolation = Isolation{{fs::path(CHILD_PROGRAM).parent_path()}, {}};
    return command;
}

}  // namespace

TEST_CASE("however a program ends, isolated it is told in the same words") {
    if (is_skipped()) return;
    for (const char* kind : {"well", "null", "astray", "stack", "divide", "abort", "assertion", "exit", "exception",
                             "number", "input", "much", "memory"}) {
        CAPTURE(kind);
        Command plain = of_child(kind, false), isolated = of_child(kind, true);
        plain.limits.memory = isolated.limits.memory = std::uint64_t{512} << 20;
        const Outcome one = run(plain), other = run(isolated);
        CHECK(other.end == one.end);
        CHECK(other.status == one.status);
        CHECK(other.output == one.output);
        CHECK(other.errors == one.errors);
        CHECK(how_it_ended(other) == how_it_ended(one));
    }
    for (const char* status : {"0", "3", "139", "255"}) {  // 139 is not signal 11, as its last words say
        CHECK(run(of_child("status", true, {status})).end == End::exited);
        CHECK(run(of_child("status", true, {status})).status == std::atoi(status));
    }
    Command loop = of_child("loop", true);
    loop.limits.time = 500ms;
    CHECK(how_it_ended(run(loop)) == "it ran for 0.5 s without ending: an endless loop?");
}

TEST_CASE("an isolated program reaches the memory that it shares, and sees no environment but what it needs") {
    if (is_skipped()) return;
    const SharedMemory memory(4096);
    auto& number = *static_cast<int*>(memory.data());
    number = 21;
    Command command = of_child("shared", true);
    command.shared = &memory;
    CHECK(run(command).well());
    CHECK(number == 42);
    const Variable secret("GLASSBOX_TEST_SECRET", "a password");
    CHECK(run(of_child("environment", false, {"GLASSBOX_TEST_SECRET"})).output == "a password\n");
    CHECK(run(of_child("environment", true, {"GLASSBOX_TEST_SECRET"})).output == "(not set)\n");
    CHECK(run(of_child("environment", true, {"HOME"})).output == "/tmp\n");
}

TEST_CASE("what an isolated program started ends with it") {
    if (is_skipped()) return;
    const auto sleepers = [] {
        int count = 0;
        std::error_code gone;
        for (const fs::directory_entry& process : fs::directory_iterator("/proc", gone))
            count += content(process.path() / "cmdline").find("glassbox-test-sleeper") != std::string::npos;
        return count;
    };
    Command command{"sh", {"-c", "sh -c 'sleep 600; : glassbox-test-sleeper' & sleep 600; : glassbox-test-sleeper"}};
    command.isolation = Isolation{};
    command.limits.time = 500ms;
    CHECK(run(command).end == End::deadline);
    for (int looks = 0; sleepers() > 0 && looks < 200; ++looks) ::usleep(10'000);
    CHECK(sleepers() == 0);
}

TEST_CASE("what a stranger's function tries succeeds without isolation, fails with it, and is graded rightly") {
    if (is_skipped()) return;
    const Machine machine;
    machine.write(machine.ada, machine.with_deed(machine.attack()));
    const Toolchain tools = toolchain(machine.teacher, nothing);
    const fs::path work = make_folder(machine.teacher.hidden() / "plain");
    const TestRun plain = run_tests(machine.teacher, machine.rays(), tools, {machine.ada / "1-rays", work});
    const std::string words =
        first_wrong_text(machine.teacher, machine.rays(), plain, judged(machine.rays(), plain), {});
    for (const char* deed :
         {"home-read", "home-included", "neighbour-read", "connected", "environment-read", "process-found"})
        CHECK_MESSAGE(words.find(deed) != std::string::npos, deed, " should be in:\n", words);
    CHECK(fs::exists(machine.home / ".profile"));
    CHECK(fs::exists(machine.outside / "file"));
    const std::string ray = content(machine.teacher.solution(machine.rays(), "ray.hpp"));
    CHECK(content(machine.ada / "1-rays/ray.hpp") != ray);

    fs::remove(machine.home / ".profile");
    fs::remove(machine.outside / "file");
    machine.write(machine.ada, machine.with_deed(machine.attack()));
    Grader grader(machine.teacher, Isolating::always, nothing);
    CHECK(grader.why_not_isolated() == "");
    const LearnerStanding standing = grader.grade(handed_in(machine.teacher, machine.ada));
    const LessonStanding& rays = standing.lessons.front();
    CHECK_MESSAGE(rays.grade == Grade::passed, rays.wrong);
    CHECK(functions_passed(rays) == 9);
    CHECK(rays.no_picture == "");
    CHECK(pixels_differing(rays) == 0);
    CHECK(machine.bystander.lives());
    CHECK_FALSE(fs::exists(machine.home / ".profile"));
    CHECK_FALSE(fs::exists(machine.outside / "file"));
    CHECK(content(machine.ada / "1-rays/ray.hpp") == ray);
}

TEST_CASE("what is wrong is told byte for byte as without isolation") {
    if (is_skipped()) return;
    const Machine machine;
    const Toolchain plain = toolchain(machine.teacher, nothing), apart = isolated(plain, machine.teacher);
    for (const char* deed : {
             "inline void deed() { volatile int* nowhere = nullptr; *nowhere = 1; }\n",
             "inline void deed() { for (volatile int i = 0;; i = i + 1) {} }\n",
             "inline void deed() { std::exit(0); }\n", "inline void deed() { ::kill(::getpid(), SIGKILL); }\n",
             "inline void deed() { return 1 }\n",  // does not compile
         }) {
        CAPTURE(deed);
        machine.write(machine.ada, machine.with_deed(deed));
        const auto told = [&](const Toolchain& tools) {
            TestRequest request{machine.ada / "1-rays", make_folder(machine.teacher.hidden() / "told"), false, 700ms};
            fs::remove(request.folder / "double-key");
            const TestRun run = run_tests(machine.teacher, machine.rays(), tools, request);
            return first_wrong_text(machine.teacher, machine.rays(), run, judged(machine.rays(), run), {});
        };
        const std::string words = told(plain);
        CHECK(words != "");
        CHECK(told(apart) == words);
    }
}

TEST_CASE("a header that is a link to somebody else's file is refused, and no error shows a line of a file elsewhere") {
    if (is_skipped()) return;
    const Machine machine;
    fs::remove(machine.ada / "1-rays/vec3.hpp");
    fs::create_symlink(machine.bo / "1-rays/vec3.hpp", machine.ada / "1-rays/vec3.hpp");
    Grader grader(machine.teacher, Isolating::always, nothing);
    const LearnerStanding standing = grader.grade(handed_in(machine.teacher, machine.ada));
    CHECK(standing.lessons.front().grade == Grade::does_not_compile);
    CHECK(standing.lessons.front().wrong.find("this is a link to a file elsewhere") != std::string::npos);

    fs::remove(machine.ada / "1-rays/vec3.hpp");
    machine.write(machine.ada,
                  machine.solution() + fmt::format("#line 1 \"{}/.ssh/id\"\nint x = y;\n", machine.home.string()));
    const LessonStanding named = grader.grade(handed_in(machine.teacher, machine.ada)).lessons.front();
    CHECK(named.grade == Grade::does_not_compile);
    CHECK(named.wrong.find("a key") == std::string::npos);
}
