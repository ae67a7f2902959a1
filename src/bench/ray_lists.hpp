#pragma once
#include <cstddef>

#include "render/parallel.hpp"

namespace glassbox {

/// Calls `work(i)` for each i from 0 to count − 1 on the job's threads, and asks only now and then whether to stop, so
/// that the timed loop contains hardly anything but the work. Throws Cancelled.
template <class Work>
void for_each_timed(std::size_t count, const Job& job, const Work& work) {
    run_parallel(tbb::blocked_range<std::size_t>(0, count, 1024), job, [&](const auto& range) {
        throw_if_stopped(job);
        for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
    });
}

}  // namespace glassbox
