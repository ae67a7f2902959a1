#include "cli/interrupt.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <string>

namespace glassbox {

namespace {

/// The destructor's signal to the waiting thread that there is nothing left to wait for. From any other sender it is
/// ignored, which is its default.
constexpr int wake_signal = SIGURG;

/// The signals that end a program by default. Not listed: SIGPIPE, which silently ends a filter when its reader has
/// seen enough, and the signals that a fault of the program itself raises.
constexpr int deadly[] = {
    SIGINT,  SIGTERM, SIGHUP,    SIGQUIT, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGUSR1, SIGUSR2,
#ifdef __linux__
    SIGPOLL, SIGPWR,  SIGSTKFLT,
#endif
};

/// Whether the signal is neither ignored nor already handled, as by a profiler.
bool would_end_us(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
}

sigset_t awaited_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : deadly)
        if (would_end_us(signal)) sigaddset(&set, signal);
    sigaddset(&set, wake_signal);
    return set;
}

/// Makes a write beyond the limit fail with EFBIG. Sets a handler, not SIG_IGN, which programs that we start would
/// inherit.
void let_writes_fail_at_the_limit() {
    struct sigaction nothing {};
    nothing.sa_handler = [](int) {};
    nothing.sa_flags = SA_RESTART;
    ::sigaction(SIGXFSZ, &nothing, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
    let_writes_fail_at_the_limit();
    const sigset_t set = awaited_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::thread([this, set] { wait_for_signal(set); });
}

Interrupt::~Interrupt() {
    {
        const std::lock_guard lock(mutex_);
        work_is_over_ = true;
    }
    over_.notify_one();
    pthread_kill(waiter_.native_handle(), wake_signal);
    waiter_.join();
}

Interrupt::Ending Interrupt::ending() const {
    if (signal_ == SIGXCPU)
        return {
            "glassbox: error: the limit on processor time (ulimit -t) is reached; raise it, or ask for less; no "
            "half-written file is left",
            1};
    return {"glassbox: interrupted; no half-written file is left", 130};
}

void Interrupt::wait_for_signal(const sigset_t& awaited) {
    const auto is_over = [this] { return work_is_over_; };
    int signal = wake_signal;
    while (signal == wake_signal) {
        sigwait(&awaited, &signal);
        const std::lock_guard lock(mutex_);
        if (is_over()) return;
    }
    signal_ = signal;
    source_.request_stop();
    std::unique_lock lock(mutex_);
    if (over_.wait_for(lock, std::chrono::milliseconds(20), is_over)) return;
    end();
}

/// Ends the program at once, whatever the other threads are doing.
void Interrupt::end() const {
    const auto [message, status] = ending();
    const std::string erase_bar = ::isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "";
    const std::string line = erase_bar + message + '\n';
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, line.data(), line.size());
    ::_exit(status);
}

}  // namespace glassbox
