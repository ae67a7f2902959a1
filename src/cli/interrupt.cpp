#include "cli/interrupt.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>

namespace glassbox {

namespace {

/// Ctrl-C, a polite kill, and the destructor's own word that nothing is left to wait for.
sigset_t awaited_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaddset(&set, signal);
    return set;
}

}  // namespace

Interrupt::Interrupt() {
    const sigset_t set = awaited_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::thread([this] { wait_for_signal(); });
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

void Interrupt::wait_for_signal() {
    const sigset_t set = awaited_signals();
    int signal = 0;
    sigwait(&set, &signal);
    if (signal == SIGUSR1) return;
    source_.request_stop();
    std::unique_lock lock(mutex_);
    if (over_.wait_for(lock, std::chrono::milliseconds(80), [this] { return work_is_over_; })) return;
    ::_exit(exit_status);
}

}  // namespace glassbox
