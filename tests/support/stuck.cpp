#include "support/stuck.hpp"

#ifdef __linux__

#include <dirent.h>
#include <execinfo.h>
#include <signal.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace glassbox::test {

namespace {

void say(const char* text) { [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, std::strlen(text)); }

/// In each thread: the functions that it is in, the innermost first.
void on_question(int) {
    void* calls[64];
    say("a thread stands in:\n");
    ::backtrace_symbols_fd(calls, ::backtrace(calls, 64), STDERR_FILENO);
}

/// Not all that is done here is allowed in a signal's handler; but nothing is left to lose.
void on_alarm(int) {
    say("this test does not come to an end. (Names: c++filt)\n");
    if (DIR* const threads = ::opendir("/proc/self/task")) {
        while (const dirent* const thread = ::readdir(threads)) {
            const long number = std::atol(thread->d_name);
            if (number <= 0) continue;
            ::syscall(SYS_tgkill, ::getpid(), number, SIGUSR1);
            const timespec for_its_answer{0, 200'000'000};
            ::nanosleep(&for_its_answer, nullptr);
        }
    }
    ::_exit(EXIT_FAILURE);
}

void on_signal(int signal, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART | SA_NODEFER;  // the thread that hears the alarm is asked, too
    ::sigaction(signal, &action, nullptr);
}

}  // namespace

void tell_where_it_is_stuck_after(unsigned seconds) {
    void* once[1];
    ::backtrace(once, 1);  // loads what it needs
    on_signal(SIGUSR1, on_question);
    on_signal(SIGALRM, on_alarm);
    ::alarm(seconds);
}

}  // namespace glassbox::test

#else

namespace glassbox::test {
void tell_where_it_is_stuck_after(unsigned) {}
}  // namespace glassbox::test

#endif
