#include "cli/program.hpp"

#include <doctest.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <thread>

extern char** environ;

namespace glassbox::test {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

void succeed(int error, const char* what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// A file without a name that takes all that the program prints, however much.
class Capture {
public:
    Capture() : file_(std::tmpfile(), &std::fclose) {
        if (!file_) throw std::runtime_error("cannot make a temporary file");
    }

    int descriptor() const { return ::fileno(file_.get()); }

    std::string text() const {
        std::string text;
        char piece[4096];
        std::rewind(file_.get());
        while (const std::size_t size = std::fread(piece, 1, sizeof piece, file_.get())) text.append(piece, size);
        return text;
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

class FileActions {
public:
    FileActions() { succeed(::posix_spawn_file_actions_init(&actions_), "file actions"); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;
    ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }

    void run_in(const fs::path& folder) {
        succeed(::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str()), "chdir");
    }
    void open(int descriptor, const char* path, int how) {
        if (path) succeed(::posix_spawn_file_actions_addopen(&actions_, descriptor, path, how, 0666), "open");
        else succeed(::posix_spawn_file_actions_addclose(&actions_, descriptor), "close");
    }
    void capture(int descriptor, const char* path, const Capture& captured) {
        if (path && *path == '\0')
            succeed(::posix_spawn_file_actions_adddup2(&actions_, captured.descriptor(), descriptor), "dup2");
        else open(descriptor, path, O_WRONLY | O_APPEND);
    }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

/// Default signal handling, as in a terminal's shell, whatever this test was started from.
class UsualSignals {
public:
    UsualSignals() {
        sigset_t all, none;
        sigfillset(&all);
        sigemptyset(&none);
        succeed(::posix_spawnattr_init(&attributes_), "attributes");
        succeed(::posix_spawnattr_setsigdefault(&attributes_, &all), "default signals");
        succeed(::posix_spawnattr_setsigmask(&attributes_, &none), "signal mask");
        succeed(::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK), "flags");
    }
    UsualSignals(const UsualSignals&) = delete;
    UsualSignals& operator=(const UsualSignals&) = delete;
    ~UsualSignals() { ::posix_spawnattr_destroy(&attributes_); }

    const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_;
};

int exit_status(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) succeed(errno, "waitpid");
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        files[entry.path().filename().string()] = entry.is_regular_file() ? content(entry.path()) : "";
    return files;
}

}  // namespace

Ran run_glassbox(const Arguments& arguments, const Surroundings& surroundings) {
    Arguments words{GLASSBOX_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    char* no_variables[] = {nullptr};

    const Capture out, err;
    FileActions actions;
    actions.run_in(surroundings.folder);
    actions.open(STDIN_FILENO, surroundings.in, O_RDONLY);
    actions.capture(STDOUT_FILENO, surroundings.out, out);
    actions.capture(STDERR_FILENO, surroundings.err, err);
    const UsualSignals signals;

    pid_t child = 0;
    Clock::time_point start = Clock::now();
    succeed(::posix_spawn(&child, GLASSBOX_PROGRAM, actions.get(), signals.get(), argv.data(),
                          surroundings.empty_environment ? no_variables : environ),
            GLASSBOX_PROGRAM);
    if (surroundings.signal_at) {
        std::this_thread::sleep_for(*surroundings.signal_at);
        start = Clock::now();
        ::kill(child, surroundings.signal);
    }
    const int status = exit_status(child);
    const std::chrono::duration<double> time = Clock::now() - start;
    return {status, out.text(), err.text(), time.count()};
}

fs::path write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

void check_refused(const Folder& folder, const Arguments& arguments, int status,
                   const std::vector<std::string>& parts) {
    std::string line = "glassbox";
    for (const std::string& argument : arguments) line += " '" + argument + "'";
    CAPTURE(line);
    const auto before = contents(folder.path);
    const Ran ran = run_glassbox(arguments, {.folder = folder.path});
    CHECK(ran.status == status);
    CHECK(ran.out == "");
    CAPTURE(ran.err);
    CHECK(std::count(ran.err.begin(), ran.err.end(), '\n') == 1);
    CHECK(ran.err.ends_with('\n'));
    for (const std::string& part : parts) CHECK_MESSAGE(ran.err.find(part) != std::string::npos, part);
    CHECK(contents(folder.path) == before);
}

}  // namespace glassbox::test
