#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>

#include "render/job.hpp"
#include "viewer/model/work/worker.hpp"

namespace glassbox {

/// Does work that says more about what is seen. If it took long the last time, it waits until the view has been at rest
/// for a moment: while the view turns it would end too late, and take the processor's time from the pictures. Throws
/// Cancelled.
template <class Work>
void do_at_rest(const Run& run, const Work& work) {
    using Clock = std::chrono::steady_clock;
    constexpr double quick = 0.01;  // seconds: less than a frame
    constexpr std::chrono::milliseconds a_moment{60};
    if (run.follows_view && !(run.pace.seconds(1) < quick)) {
        std::mutex mutex;
        std::unique_lock lock(mutex);
        std::condition_variable_any never;
        never.wait_for(lock, run.stop, a_moment, [] { return false; });
        if (run.stop.stop_requested()) throw Cancelled{};
    }
    const auto start = Clock::now();
    run.pace = Pace();  // what counts is the last time; of work that is cancelled nothing is known
    work();
    run.pace.note(1, std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace glassbox
