#include "render/assumptions.hpp"

#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include "render/parallel.hpp"

namespace glassbox {

namespace {

/// An assumption that fails in any thread fails: `found` keeps the worst result.
void add(std::vector<Assumption>& found, const std::vector<Assumption>& elsewhere, const char* where) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i].not_in.empty() && !elsewhere[i].not_in.empty()) found[i].not_in = elsewhere[i].not_in + where;
}

/// One result for each thread that computes pictures, if it starts in time.
std::vector<std::vector<Assumption>> of_workers() {
    using Clock = std::chrono::steady_clock;
    const int workers = tbb::info::default_concurrency();
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(200);
    std::vector<std::vector<Assumption>> found;
    std::mutex mutex;
    std::set<std::thread::id> seen;
    run_parallel(tbb::blocked_range<int>(0, workers), {}, [&](const tbb::blocked_range<int>&) {
        std::vector<Assumption> here = try_assumptions();
        const auto all_seen = [&] {
            const std::lock_guard lock(mutex);
            return seen.size() == static_cast<std::size_t>(workers);
        };
        {
            const std::lock_guard lock(mutex);
            if (seen.insert(std::this_thread::get_id()).second) found.push_back(std::move(here));
        }
        while (!all_seen() && Clock::now() < end) std::this_thread::yield();  // else one thread would run all of them
    });
    return found;
}

}  // namespace

std::vector<Assumption> try_assumptions_in_threads() {
    std::vector<Assumption> found = try_assumptions();
    for (const std::vector<Assumption>& worker : of_workers()) add(found, worker, " in a worker thread");
    std::vector<Assumption> in_new_thread;
    std::thread([&] { in_new_thread = try_assumptions(); }).join();
    add(found, in_new_thread, " in a new thread");
    return found;
}

}  // namespace glassbox
