#pragma once
#include <tbb/blocked_range.h>
#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <cstdint>

#include "engine/with_threads.hpp"
#include "render/job.hpp"

namespace glassbox {

/// Pixels on a side of a block: what a thread does in one go.
inline constexpr int block_side = 32;

/// Calls `body` on parts of the range on the job's threads, which may be more than there are cores.
template <class Range, class Body>
void run_parallel(const Range& range, const Job& job, const Body& body) {
    engine::with_threads(job.threads, [&] { tbb::parallel_for(range, body, tbb::simple_partitioner{}); });
}

/// Throws Cancelled if the job was asked to stop, but not before job.not_before.
inline void throw_if_stopped(const Job& job) {
    if (job.stop.stop_requested() && std::chrono::steady_clock::now() >= job.not_before) throw Cancelled{};
}

/// Calls `work(columns, rows)` once for every block of a picture's pixels on the job's threads, in no fixed order.
template <class Work>
void for_each_block(int width, int height, const Job& job, const Work& work) {
    const tbb::blocked_range2d<int> all(0, height, block_side, 0, width, block_side);
    run_parallel(all, job, [&](const auto& block) { work(block.cols(), block.rows()); });
}

/// Calls `work(x, y)` once for every pixel, block by block. Throws Cancelled at the next pixel when the job is asked to
/// stop.
template <class Work>
void for_each_pixel(int width, int height, const Job& job, const Work& work) {
    for_each_block(width, height, job, [&](const auto& columns, const auto& rows) {
        for (int y = rows.begin(); y != rows.end(); ++y) {
            for (int x = columns.begin(); x != columns.end(); ++x) {
                throw_if_stopped(job);
                work(x, y);
            }
            if (job.done) *job.done += columns.end() - columns.begin();
        }
    });
}

/// Calls `work(i)` once for each i from 0 to count − 1, in the same way.
template <class Work>
void for_each_index(std::size_t count, const Job& job, const Work& work) {
    run_parallel(tbb::blocked_range<std::size_t>(0, count, 256), job, [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            throw_if_stopped(job);
            work(i);
        }
        if (job.done) *job.done += static_cast<std::int64_t>(range.size());
    });
}

}  // namespace glassbox
