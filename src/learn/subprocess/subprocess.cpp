#include "learn/subprocess/subprocess.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

#include "scene/error.hpp"

extern char** environ;

namespace glassbox::learn {
namespace {

using Clock = std::chrono::steady_clock;

/// The descriptors of the memory handed to a child; its environment names them.
constexpr int last_words_descriptor = 3;
constexpr int shared_descriptor = 4;

[[noreturn]] void fail(const std::string& what, int number) {
    throw Error(fmt::format("error: cannot {}: {}; close other programs and try again", what,
                            std::system_category().message(number)));
}

/// An open file descriptor, closed by the destructor.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~Descriptor() { close(); }

    int number() const { return number_; }
    void close() {
        if (number_ >= 0) ::close(std::exchange(number_, -1));
    }

private:
    int number_;
};

struct Pipe {
    Descriptor read, write;
};

/// Makes a pipe that no child inherits by accident, its ends above the descriptors that a child is given.
Pipe make_pipe() {
    int ends[2];
    if (::pipe(ends) != 0) fail("make a pipe", errno);
    Pipe pipe{Descriptor(::fcntl(ends[0], F_DUPFD_CLOEXEC, 10)), Descriptor(::fcntl(ends[1], F_DUPFD_CLOEXEC, 10))};
    ::close(ends[0]);
    ::close(ends[1]);
    if (pipe.read.number() < 0 || pipe.write.number() < 0) fail("make a pipe", errno);
    ::fcntl(pipe.read.number(), F_SETFL, O_NONBLOCK);
    return pipe;
}

/// One of a child's outputs: the beginning is kept, the rest read and dropped, so that the child never waits for us.
class Captured {
public:
    explicit Captured(std::size_t kept) : kept_(kept) {}

    /// Reads what is available; false at the end.
    bool take(const Descriptor& from) {
        std::array<char, 65536> buffer;
        const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
        waiting_ = count < 0;
        if (waiting_) return errno == EINTR || errno == EAGAIN;
        const auto bytes = static_cast<std::size_t>(count);
        text_.append(buffer.data(), std::min(bytes, kept_ - text_.size()));
        total_ += bytes;
        return bytes > 0;
    }

    /// Reads what an ended process left in the pipe, whose other end may still be held by a process that left its
    /// session.
    void take_rest(const Descriptor& from, std::size_t most) {
        if (from.number() < 0) return;
        waiting_ = false;
        while (total_ < most && take(from) && !waiting_) {
        }
    }

    std::size_t total() const { return total_; }
    std::string text() && { return std::move(text_); }

private:
    std::size_t kept_;
    std::size_t total_ = 0;
    bool waiting_ = false;  // nothing was available at the last read
    std::string text_;
};

/// A shell sets the limits and executes the program. posix_spawn cannot set limits; setting them from outside (prlimit)
/// would be a moment too late, and Linux only; and after fork() in a program with threads, little more than exec is
/// allowed. A limit that the system does not know, or that is above our own, stays as it is.
std::string launcher(const Command& command) {
    const Limits& limits = command.limits;
    using std::chrono::seconds;
    const auto processor = command.has_got_on ? seconds(std::chrono::hours(1)).count()
                                              : std::chrono::duration_cast<seconds>(limits.time).count() * 2 + 2;
    const std::uint64_t stack = 8192;  // KiB: an endless recursion should end soon, and everywhere in the same way
    std::string script = fmt::format("ulimit -c 0; ulimit -t {}; ulimit -f {}; ulimit -s {};", processor,
                                     std::max<std::uint64_t>(limits.file / 512, 1), stack);
    if (limits.memory > 0) script += fmt::format(" ulimit -v {};", std::max<std::uint64_t>(limits.memory / 1024, 1));
    return "{ " + script + " } 2>/dev/null; exec \"$@\"";
}

std::vector<std::string> environment_of(const Command& command) {
    auto added = command.isolation ? environment_of_isolated() : decltype(command.environment){};
    added.insert(added.end(), command.environment.begin(), command.environment.end());
    added.emplace_back(last_words_variable, std::to_string(last_words_descriptor));
    if (command.shared) added.emplace_back(shared_memory_variable, std::to_string(shared_descriptor));
    std::vector<std::string> all;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string_view text = *entry;
        const std::string_view name = text.substr(0, text.find('='));
        const bool replaced =
            name == shared_memory_variable || (command.isolation && !is_for_isolated(name)) ||
            std::any_of(added.begin(), added.end(), [&](const auto& one) { return one.first == name; });
        if (!replaced) all.emplace_back(text);
    }
    for (const auto& [name, value] : added) all.push_back(name + "=" + value);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Starts the launcher; returns the id of its process, which is also that of its session and its group.
pid_t start(const Command& command, const SharedMemory& last_words, const Pipe& output, const Pipe& errors) {
    std::vector<std::string> arguments{"sh", "-c", launcher(command), "sh"};
    if (command.isolation)
        for (std::string& word : isolating_command(*command.isolation, command.folder))
            arguments.push_back(std::move(word));
    arguments.push_back(command.program.string());
    arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
    std::vector<std::string> environment = environment_of(command);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output.write.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors.write.number(), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions, last_words.descriptor(), last_words_descriptor);
    if (command.shared) posix_spawn_file_actions_adddup2(&actions, command.shared->descriptor(), shared_descriptor);
    if (!command.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());

    // Our caller may have blocked or ignored signals; the program should get them as from a shell.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    for (const int untouchable : {SIGKILL, SIGSTOP}) sigdelset(&all, untouchable);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    pid_t process = -1;
    const int problem = ::posix_spawn(&process, "/bin/sh", &actions, &attributes, pointers(arguments).data(),
                                      pointers(environment).data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) fail("start a process", problem);
    return process;
}

/// A running process; the destructor ends it and its session, whatever happens.
class Process {
public:
    explicit Process(pid_t number) : number_(number) {
#if defined(__linux__) && defined(SYS_pidfd_open)
        ended_ = Descriptor(static_cast<int>(::syscall(SYS_pidfd_open, number, 0)));
#endif
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (number_ > 0) reap();
    }

    /// Readable when the process has ended; -1 where the system has no such descriptor, and has_ended() must be called.
    int ended() const { return ended_.number(); }

    bool has_ended() const {
        siginfo_t info{};
        return ::waitid(P_PID, static_cast<id_t>(number_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
    }

    /// Ends the process, if it has not ended, and all of its session; returns its status as from waitpid. Ends the
    /// session before it waits for the process: until then nobody else can get its number.
    int reap() {
        ::kill(-number_, SIGKILL);
        ::kill(number_, SIGKILL);
        int status = 0;
        while (::waitpid(number_, &status, 0) < 0 && errno == EINTR) {
        }
        number_ = -1;
        return status;
    }

private:
    pid_t number_;
    Descriptor ended_;
};

bool is_program(const std::filesystem::path& file) {
    std::error_code none;
    return std::filesystem::is_regular_file(file, none) && ::access(file.c_str(), X_OK) == 0;
}

bool is_in_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::string_view folders = path ? path : "/usr/bin:/bin";
    while (!program.empty()) {
        const std::size_t end = std::min(folders.find(':'), folders.size());
        if (is_program(std::filesystem::path(folders.substr(0, end)) / program)) return true;
        if (end == folders.size()) break;
        folders.remove_prefix(end + 1);
    }
    return false;
}

/// Returns why the program cannot be run, if that is easy to see; the shell's own words do not help.
std::string why_not(const Command& command) {
    std::error_code ignored;
    if (!command.folder.empty() && !std::filesystem::is_directory(command.folder, ignored))
        return fmt::format("{}: error: there is no such folder", command.folder.string());
    const std::string program = command.program.string();
    if (program.find('/') != std::string::npos &&
        !is_program(command.program.is_absolute() ? command.program : command.folder / command.program))
        return fmt::format("{}: error: there is no such program", program);
    std::vector<std::string> looked_up{command.isolation ? "bwrap" : program, program};
    for (const std::string& name : looked_up)
        if (name.find('/') == std::string::npos && !is_in_path(name))
            return fmt::format("{}: error: there is no such program in PATH; install it", name);
    return "";
}

/// What bubblewrap's exit status says about the program that it ran: like a shell, it adds 128 to a signal's number. If
/// the program itself called exit() with such a status, its last words say so.
std::optional<int> signal_of_isolated(const LastWords& words, int exit_status) {
    const bool exited = words.kind == LastWords::left || words.kind == LastWords::finished;
    if (exited || exit_status <= 128 || exit_status > 128 + 64) return {};
    return exit_status - 128;
}

/// Whether the program probably ran out of memory. A guess: a failed new reports it, and the system kills with a signal
/// that nobody else sends.
bool looks_like_memory(const LastWords& words, int signal, const std::string& errors) {
    const std::string_view text = words.text;
    if (words.kind == LastWords::threw) return text == "std::bad_alloc" || text == "std::bad_array_new_length";
    return signal == SIGKILL || (signal == SIGABRT && errors.find("std::bad_alloc") != std::string::npos);
}

}  // namespace

Outcome run(const Command& command, const std::stop_token& stop) {
    Outcome outcome;
    outcome.limits = command.limits;
    outcome.errors = why_not(command);
    if (!outcome.errors.empty()) return outcome;

    const SharedMemory last_words(sizeof(LastWords));
    Pipe output = make_pipe(), errors = make_pipe(), wake = make_pipe();
    const std::stop_callback on_stop(
        stop, [&wake] { [[maybe_unused]] const ssize_t ignored = ::write(wake.write.number(), "", 1); });
    const auto start_time = Clock::now();
    auto deadline = start_time + command.limits.time;
    Process process(start(command, last_words, output, errors));
    output.write.close();
    errors.write.close();

    Captured said(command.limits.output), complained(command.limits.output);
    outcome.end = End::exited;
    while (true) {
        std::array<pollfd, 4> events{pollfd{process.ended(), POLLIN, 0}, pollfd{wake.read.number(), POLLIN, 0},
                                     pollfd{output.read.number(), POLLIN, 0}, pollfd{errors.read.number(), POLLIN, 0}};
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
        const decltype(left) look_again = process.ended() < 0 ? 5 : command.has_got_on ? 50 : left;
        const auto longest = std::min(left, look_again);
        ::poll(events.data(), events.size(), static_cast<int>(std::max<decltype(left)>(longest, 0)));
        if (events[2].revents != 0 && !said.take(output.read)) output.read.close();
        if (events[3].revents != 0 && !complained.take(errors.read)) errors.read.close();
        if (process.has_ended()) break;
        if (command.has_got_on && command.has_got_on()) deadline = Clock::now() + command.limits.time;
        if (stop.stop_requested()) outcome.end = End::stopped;
        else if (Clock::now() >= deadline) outcome.end = End::deadline;
        else if (said.total() + complained.total() > command.limits.endless) outcome.end = End::output;
        if (outcome.end != End::exited) break;
    }
    const int status = process.reap();
    outcome.took = Clock::now() - start_time;
    said.take_rest(output.read, command.limits.endless);
    complained.take_rest(errors.read, command.limits.endless);
    outcome.output = std::move(said).text();
    outcome.errors = std::move(complained).text();
    std::memcpy(static_cast<void*>(&outcome.last_words), last_words.data(), sizeof(LastWords));
    outcome.last_words.text[sizeof(outcome.last_words.text) - 1] = '\0';

    if (outcome.end != End::exited) return outcome;
    std::optional<int> signal;
    if (WIFSIGNALED(status)) signal = WTERMSIG(status);
    else if (command.isolation) signal = signal_of_isolated(outcome.last_words, WEXITSTATUS(status));
    if (signal) {
        outcome.status = *signal;
        outcome.end = outcome.status == SIGXCPU                                               ? End::deadline
                      : looks_like_memory(outcome.last_words, outcome.status, outcome.errors) ? End::memory
                                                                                              : End::signal;
    } else {
        outcome.status = WEXITSTATUS(status);
    }
    return outcome;
}

}  // namespace glassbox::learn
