#pragma once
#include <signal.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace glassbox {

/// While it exists, Ctrl-C, or any other signal that would end the program and can wait (SIGTERM, a closed terminal, an
/// alarm, the soft limit on processor time), asks the work to stop instead of killing the program. Work that does not
/// stop within 20 ms is ended; half-written files are gone by then, because their writer reacts to the request at once.
/// A signal that the program was started to ignore, as by nohup, stays ignored; a file that grows beyond the limit on
/// its size is a write error. Create it before any other thread: threads inherit the signals that it blocks.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }

    /// The message of a program that was asked to stop, and its exit status.
    struct Ending {
        const char* message;
        int status;
    };
    Ending ending() const;

private:
    void wait_for_signal(const sigset_t& awaited);
    [[noreturn]] void end() const;

    std::stop_source source_;
    std::atomic<int> signal_ = 0;
    std::mutex mutex_;
    std::condition_variable over_;
    bool work_is_over_ = false;
    std::thread waiter_;
};

}  // namespace glassbox
