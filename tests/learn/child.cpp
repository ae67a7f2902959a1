#include "learn/subprocess/subprocess.hpp"

#include <doctest.h>
#include <pthread.h>
#include <signal.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "output/folder.hpp"

using namespace glassbox;
using namespace glassbox::learn;
using glassbox::test::Folder;
using namespace std::chrono_literals;

namespace {

Command ending(const std::string& kind, const std::vector<std::string>& more = {}) {
    Command command{CHILD_PROGRAM, {kind}};
    command.arguments.insert(command.arguments.end(), more.begin(), more.end());
    command.limits.time = 20s;
    return command;
}

/// Whether the process with that number has ended. Someone may yet have to fetch its exit status: waits a little for
/// that.
bool is_gone(pid_t process) {
    for (int i = 0; i < 500; ++i) {
        if (::kill(process, 0) != 0) return true;
        std::ifstream state("/proc/" + std::to_string(process) + "/stat");
        const std::string text{std::istreambuf_iterator<char>(state), {}};
        if (text.find(") Z ") != std::string::npos) return true;
        std::this_thread::sleep_for(10ms);
    }
    return false;
}

}  // namespace

TEST_CASE("a program that works: its outputs, its exit status, nothing to say") {
    const Outcome outcome = run(ending("well"));
    CHECK(outcome.well());
    CHECK(outcome.end == End::exited);
    CHECK(outcome.status == 0);
    CHECK(outcome.output == "out\n");
    CHECK(outcome.errors == "err\n");
    CHECK(outcome.last_words.kind == LastWords::finished);
    CHECK(how_it_ended(outcome) == "");
    CHECK(outcome.took.count() > 0);
    CHECK(outcome.took.count() < 20);
}

TEST_CASE("arguments arrive as they are, whatever a shell would make of them") {
    CHECK(run(ending("arguments", {"a b", "$HOME", "'\"*;", "", "-n"})).output == "[a b][$HOME]['\"*;][][-n]");
}

TEST_CASE("the environment is ours, with what is added and replaced") {
    Command command = ending("environment", {"GLASSBOX_TEST"});
    CHECK(run(command).output == "(not set)\n");
    command.environment = {{"GLASSBOX_TEST", "one=two"}};
    CHECK(run(command).output == "one=two\n");
    command = ending("environment", {"HOME"});
    command.environment = {{"HOME", "/nowhere"}};
    CHECK(run(command).output == "/nowhere\n");
    command.environment.clear();
    CHECK(run(command).output == std::string(std::getenv("HOME") ? std::getenv("HOME") : "(not set)") + "\n");
}

TEST_CASE("it runs in the folder that is asked for, and has nothing to read") {
    const Folder folder;
    Command command = ending("folder");
    command.folder = folder.path;
    CHECK(run(command).output == std::filesystem::canonical(folder.path).string() + "\n");
    CHECK(run(ending("input")).output == "-1\n");  // getchar() == EOF
}

TEST_CASE("what cannot be started is told") {
    const Outcome missing = run({"/no/such/program", {}});
    CHECK(missing.end == End::not_started);
    CHECK(!missing.well());
    CHECK(how_it_ended(missing) == "/no/such/program: error: there is no such program");
    CHECK(how_it_ended(run({"no-such-program-anywhere", {}})) ==
          "no-such-program-anywhere: error: there is no such program in PATH; install it");
    Command command = ending("well");
    command.folder = "/no/such/folder";
    CHECK(how_it_ended(run(command)) == "/no/such/folder: error: there is no such folder");
    CHECK(run({"true", {}}).well());
}

TEST_CASE("exit statuses") {
    const Outcome outcome = run(ending("status", {"3"}));
    CHECK(outcome.end == End::exited);
    CHECK(outcome.status == 3);
    CHECK(how_it_ended(run({"sh", {"-c", "echo no such scene >&2; exit 2"}})) ==
          "it ended with exit status 2: no such scene");
}

TEST_CASE("hostile ends are told in words") {
    const auto words = [](const std::string& kind) { return how_it_ended(run(ending(kind))); };
    CHECK(words("null") == "it followed a null pointer (address 0x8)");  // y lies after x, 8 bytes on
    CHECK(words("astray") ==
          "it touched memory that is not its own (address 0x7ff000000008): a pointer or an index gone astray?");
    CHECK(words("stack") == "its stack overflowed: a function that calls itself without end?");
#if defined(__x86_64__) || defined(__i386__)  // elsewhere 1 / 0 may be a number
    CHECK(words("divide") == "it divided a whole number by zero");
#endif
    CHECK(words("abort") == "it gave up (abort)");
    CHECK(words("assertion") == "it gave up (abort): vec3.hpp:12: Assertion 'i < 3' failed.");
    CHECK(words("beyond-a-vector") == "it reached beyond the end of a vector: is an index too large?");
    CHECK(words("empty-optional") == "it used the value of an optional that has none: ask first whether there is one");
    CHECK(words("exit") == "it called exit(0) before its work was done");
    CHECK(words("exception") == "it threw an exception that nobody caught: h is not a unit vector");
    CHECK(words("number") == "it threw an exception that nobody caught: the number 42");
    CHECK(run(ending("exit")).well() == false);
}

TEST_CASE("an endless loop ends at the deadline, even if it ignores signals") {
    for (const char* kind : {"loop", "ignores-signals"}) {
        Command command = ending(kind);
        command.limits.time = 300ms;
        const Outcome outcome = run(command);
        CHECK(outcome.end == End::deadline);
        CHECK(outcome.took >= 300ms);
        CHECK(outcome.took < 5s);
        CHECK(how_it_ended(outcome) == "it ran for 0.3 s without ending: an endless loop?");
    }
}

TEST_CASE("what gets on has time; once it does not, the time is up") {
    Command command = ending("loop");
    command.limits.time = 200ms;
    int asked = 0;
    command.has_got_on = [&] { return ++asked <= 10; };  // about every 50 ms
    const Outcome outcome = run(command);
    CHECK(outcome.end == End::deadline);
    CHECK(asked > 10);
    CHECK(outcome.took >= 400ms);
    CHECK(outcome.took < 10s);
}

TEST_CASE("endless output ends; much output is cut, and not waited for") {
    Command command = ending("print");
    command.limits.endless = std::size_t{4} << 20;
    const Outcome endless = run(command);
    CHECK(endless.end == End::output);
    CHECK(endless.output.size() == command.limits.output);
    CHECK(endless.output.substr(0, 15) == "again and again");
    CHECK(how_it_ended(endless) == "it wrote more than 4 MiB without ending: an endless loop that prints?");

    command = ending("much");
    command.limits.output = 100;
    const Outcome much = run(command);
    CHECK(much.well());
    CHECK(much.output == "the beginning" + std::string(87, '.'));
}

TEST_CASE("too much memory") {
    Command command = ending("memory");
    command.limits.memory = std::uint64_t{512} << 20;
    const Outcome outcome = run(command);
    CHECK(outcome.end == End::memory);
    CHECK(how_it_ended(outcome) ==
          "it asked for more memory than it may have (512 MiB): does something grow without end?");
}

TEST_CASE("a file that grows without end") {
    const Folder folder;
    Command command = ending("file", {(folder.path / "large").string()});
    command.limits.file = std::uint64_t{3} << 20;
    CHECK(how_it_ended(run(command)) == "it wrote a file of more than 3 MiB");
    CHECK(std::filesystem::file_size(folder.path / "large") <= command.limits.file);
}

TEST_CASE("what it started ends with it") {
    const Outcome outcome = run(ending("family"));
    CHECK(outcome.well());
    const int grandchild = std::stoi(outcome.output);
    CHECK(grandchild > 1);
    CHECK(is_gone(grandchild));
}

TEST_CASE("it can be stopped from another thread, before and while it runs") {
    std::stop_source source;
    std::jthread stopper([&] {
        std::this_thread::sleep_for(200ms);
        source.request_stop();
    });
    const Outcome outcome = run(ending("loop"), source.get_token());
    CHECK(outcome.end == End::stopped);
    CHECK(outcome.took < 10s);
    CHECK(how_it_ended(outcome) == "it was stopped");
    CHECK(run(ending("loop"), source.get_token()).end == End::stopped);
}

TEST_CASE("shared memory is seen by both, and by no program that it is not given to") {
    const SharedMemory memory(4096);
    auto& number = *static_cast<int*>(memory.data());
    CHECK(number == 0);
    number = 21;
    Command command = ending("shared");
    command.shared = &memory;
    CHECK(run(command).well());
    CHECK(number == 42);
    CHECK(run(ending("environment", {shared_memory_variable})).output == "(not set)\n");
}

TEST_CASE("signals that we block and ignore are not blocked and ignored there") {
    sigset_t blocked, before;
    sigemptyset(&blocked);
    sigaddset(&blocked, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &blocked, &before);
    const auto old = ::signal(SIGINT, SIG_IGN);
    CHECK(how_it_ended(run({"sh", {"-c", "kill -TERM $$; sleep 5"}})).substr(0, 9) == "signal 15");
    CHECK(how_it_ended(run({"sh", {"-c", "kill -INT $$; sleep 5"}})).substr(0, 8) == "signal 2");
    ::signal(SIGINT, old);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

TEST_CASE("several threads may run programs at once; none waits for another's") {
    std::vector<std::jthread> threads;
    std::array<Outcome, 8> outcomes;
    for (std::size_t i = 0; i < outcomes.size(); ++i)
        threads.emplace_back([&outcomes, i] {
            Command command = ending(i % 2 ? "well" : "loop");
            if (i % 2 == 0) command.limits.time = 1s;
            outcomes[i] = run(command);
        });
    threads.clear();
    for (std::size_t i = 0; i < outcomes.size(); ++i) CHECK(outcomes[i].end == (i % 2 ? End::exited : End::deadline));
}
