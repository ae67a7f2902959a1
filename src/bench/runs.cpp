#include "bench/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

namespace glassbox {

namespace {

constexpr double shortest_run = 0.1;  // seconds

double million_rays_a_second(const Work& work) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    for (int repeats = 1;; ++repeats) {
        work.run();
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (seconds >= shortest_run) return repeats * work.rays / seconds / 1e6;
    }
}

}  // namespace

Spread spread(std::vector<double> numbers) {
    std::sort(numbers.begin(), numbers.end());
    return {numbers.front(), numbers[numbers.size() / 2], numbers.back()};
}

std::string to_text(const Spread& spread) {
    return fmt::format("{:.3g} ({:.3g} ... {:.3g})", spread.median, spread.least, spread.greatest);
}

Speeds time_in_turn(const std::vector<Work>& works, int runs, std::atomic<std::int64_t>* done) {
    for (const Work& work : works) work.run();  // the first time fills caches and starts threads
    Speeds speeds(works.size());
    for (int run = 0; run < runs; ++run)
        for (std::size_t w = 0; w < works.size(); ++w) {
            speeds[w].push_back(million_rays_a_second(works[w]));
            if (done) ++*done;
        }
    return speeds;
}

Spread ratio(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> ratios;
    std::transform(one.begin(), one.end(), other.begin(), std::back_inserter(ratios), std::divides<>{});
    return spread(std::move(ratios));
}

std::vector<double> nanoseconds(std::vector<double> speeds) {
    for (double& speed : speeds) speed = 1000 / speed;
    return speeds;
}

}  // namespace glassbox
