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

/// Connects long work to its caller: how many threads it may use, how far it is, and whether it should stop.
struct Job {
    int threads = 0;                            ///< 0: as many as the machine has cores
    std::stop_token stop;                       ///< when requested, the work throws Cancelled at the next pixel
    std::atomic<std::int64_t>* done = nullptr;  ///< counts finished pixels or rays, if not null
    /// The engine with the stage's surfaces, if already built; otherwise it is built when needed.
    std::shared_ptr<const engine::Engine> engine = {};
    /// Ignore stop requests before this time.
    std::chrono::steady_clock::time_point not_before = {};
};

/// Thrown by work that stopped on request before it was done.
struct Cancelled {};

}  // namespace glassbox
