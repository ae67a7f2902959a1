#pragma once
#include <signal.h>

#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>

namespace glassbox {

/// While it lives, Ctrl-C (or SIGTERM, or SIGHUP from a terminal that goes) asks the work to stop instead of killing
/// the program. Work that cannot stop within 20 ms is ended, with the exit status of an interrupted program;
/// half-written files are gone by then, because their writer answers the request at once. A signal that the program was
/// started to ignore, as nohup does, stays ignored. Make it before any other thread: they inherit which signals are its
/// own.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }

    static constexpr int exit_status = 130;
    static constexpr const char* message = "glassbox: interrupted; no half-written file is left";

private:
    void wait_for_signal(const sigset_t& awaited);

    std::stop_source source_;
    std::mutex mutex_;
    std::condition_variable over_;
    bool work_is_over_ = false;
    std::thread waiter_;
};

}  // namespace glassbox
