#include "cli/interrupt.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <string>

namespace glassbox {

namespace {

bool is_ignored(int signal) {
    struct sigaction action {};
    return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

/// Ctrl-C, a polite kill, a closed terminal; and the destructor's own word that nothing is left to wait for.
sigset_t awaited_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal)) sigaddset(&set, signal);
    sigaddset(&set, SIGUSR1);
    return set;
}

/// Ends the program at once, whatever the other threads are doing.
[[noreturn]] void end() {
    const std::string erase_bar = ::isatty(STDERR_FILENO) == 1 ? "\r\x1b[K" : "";
    const std::string line = erase_bar + std::string(Interrupt::message) + '\n';
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, line.data(), line.size());
    ::_exit(Interrupt::exit_status);
}

}  // namespace

Interrupt::Interrupt() {
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
    pthread_kill(waiter_.native_handle(), SIGUSR1);
    waiter_.join();
}

void Interrupt::wait_for_signal(const sigset_t& awaited) {
    int signal = 0;
    sigwait(&awaited, &signal);
    if (signal == SIGUSR1) return;
    source_.request_stop();
    std::unique_lock lock(mutex_);
    if (over_.wait_for(lock, std::chrono::milliseconds(20), [this] { return work_is_over_; })) return;
    end();
}

}  // namespace glassbox
