#include "support/watchdog.hpp"

#if defined(__linux__) && __has_include(<execinfo.h>)

#include <dirent.h>
#include <execinfo.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

namespace glassbox::test {

namespace {

/// Of the thread that gets the signal, the innermost call first.
void print_stack(int) {
    void* calls[64];
    ::backtrace_symbols_fd(calls, ::backtrace(calls, 64), STDERR_FILENO);
}

/// Asks one after the other, so that no two print at once.
void print_all_stacks() {
    DIR* const threads = ::opendir("/proc/self/task");
    if (!threads) return;
    while (const dirent* const entry = ::readdir(threads)) {
        const long thread = std::atol(entry->d_name);
        if (thread <= 0 || thread == ::syscall(SYS_gettid)) continue;
        std::fprintf(stderr, "thread %ld, innermost call first:\n", thread);
        ::syscall(SYS_tgkill, ::getpid(), thread, SIGUSR1);
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    ::closedir(threads);
}

}  // namespace

void start_watchdog(std::chrono::seconds limit) {
    void* once[1];
    ::backtrace(once, 1);  // loads what it needs
    struct sigaction action {};
    action.sa_handler = print_stack;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGUSR1, &action, nullptr);
    std::thread([limit] {
        std::this_thread::sleep_for(limit);
        std::fputs(
            "this test has run too long; its threads' stacks follow. "
            "For names: c++filt; for (+0x...): addr2line -Cfie PROGRAM 0x...\n",
            stderr);
        print_all_stacks();
        std::_Exit(EXIT_FAILURE);
    }).detach();
}

}  // namespace glassbox::test

#else

namespace glassbox::test {
void start_watchdog(std::chrono::seconds) {}
}  // namespace glassbox::test

#endif
