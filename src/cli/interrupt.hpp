#pragma once
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace glassbox {

/// While it lives, Ctrl-C (and SIGTERM) asks the work to stop instead of killing the program. Work that cannot stop
/// within 80 ms is ended, with the exit status of an interrupted program; half-written files are gone by then, because
/// their writer answers the request at once. Make it before any other thread: they inherit which signals are its own.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }

    static constexpr int exit_status = 130;

private:
    void wait_for_signal();

    std::stop_source source_;
    std::mutex mutex_;
    std::condition_variable over_;
    bool work_is_over_ = false;
    std::thread waiter_;
};

}  // namespace glassbox
