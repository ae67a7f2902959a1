#pragma once
#include <algorithm>
#include <chrono>
#include <utility>

#include "render/job.hpp"
#include "render/view.hpp"
#include "scene/scene.hpp"
#include "viewer/model/work/pace.hpp"

namespace glassbox {

/// Computes a view of a scene in finer and finer sizes, 1/factor of its width and height, by `make(scene, factor,
/// job)`, until it has all its pixels, and hands each to `show`. The first size is quick, however long the whole one
/// takes; sizes that take no time are skipped. `pace` keeps how long each size takes, from one call to the next.
///
/// What takes no longer than a frame is not stopped, and is shown even if something newer is wanted, so that a view
/// that turns with the mouse is seen turning, 20 times a second. Throws Cancelled.
template <class Make, class Show>
void coarse_to_fine(const Scene& scene, Job job, Pace& pace, const Make& make, const Show& show) {
    using Clock = std::chrono::steady_clock;
    constexpr double a_frame = 0.045;  // seconds: 20 a second, and a little to spare
    constexpr int least_side = 8;
    const auto made = [&](int factor, bool quick) {
        const auto start = Clock::now();
        const auto note = [&] { pace.note(factor, std::chrono::duration<double>(Clock::now() - start).count()); };
        // Allow more time than expected: the machine may be busy.
        constexpr auto more = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(2 * a_frame));
        job.not_before = quick ? start + more : Clock::time_point();
        try {
            auto result =
                make(factor == 1 ? scene : resized(scene, scene.width / factor, scene.height / factor), factor, job);
            note();
            return result;
        } catch (const Cancelled&) {
            if (quick) note();  // it was not quick
            throw;
        }
    };

    int factor = Pace::coarsest;
    while (factor > 1 && std::min(scene.width, scene.height) / factor < least_side) factor /= 2;
    factor = pace.finest_within(a_frame, factor);
    bool quick = true;
    while (factor > 1) {
        auto coarse = made(factor, quick);
        double expected = 4 * pace.seconds(factor);  // for the next size, with four times the pixels
        for (factor /= 2; factor > 1 && 4 * expected < a_frame; factor /= 2) expected *= 4;
        quick = std::min(expected, pace.seconds(factor)) < a_frame;
        if (quick) continue;
        show(std::move(coarse));
        if (job.stop.stop_requested()) throw Cancelled{};
    }
    show(made(1, quick));
}

}  // namespace glassbox
