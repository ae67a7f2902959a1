#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <stop_token>

namespace glassbox {

namespace engine {
class Engine;
}

/// Long work's line to whoever started it: how many threads it may use, how far it is, and whether it should stop.
struct Job {
    int threads = 0;                            ///< 0: as many as the machine has cores
    std::stop_token stop;                       ///< when requested, the work throws Cancelled at the next pixel
    std::atomic<std::int64_t>* done = nullptr;  ///< counts finished pixels or rays, if anyone watches
    /// The scene's surfaces of the stage, if they were made ready before; else they are when they are needed.
    std::shared_ptr<const engine::Engine> engine = {};
    /// Asked to stop, the work goes on until this moment all the same.
    std::chrono::steady_clock::time_point not_before = {};
};

/// Thrown by work that was asked to stop before it was done.
struct Cancelled {};

}  // namespace glassbox
