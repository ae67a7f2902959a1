#pragma once
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace glassbox::engine {

/// Calls `work`, in which TBB runs on so many threads; 0: as many as the machine has cores.
template <class Work>
void with_threads(int threads, const Work& work) {
    if (threads <= 0) threads = tbb::info::default_concurrency();
    const tbb::global_control enough(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    tbb::task_arena(threads).execute(work);
}

}  // namespace glassbox::engine
