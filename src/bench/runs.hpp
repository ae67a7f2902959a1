#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace glassbox {

/// The least, the median and the greatest of several numbers.
struct Spread {
    double least, median, greatest;
};

/// Needs at least one number.
Spread spread(std::vector<double> numbers);

/// "1.15 (1.1 ... 1.23)": the median, the least and the greatest.
std::string to_text(const Spread& spread);

/// Work to be timed: its name, how many rays it traces, and the function that does it.
struct Work {
    std::string name;
    double rays;
    std::function<void()> run;
};

/// Million rays per second of each work in each run.
using Speeds = std::vector<std::vector<double>>;

/// Times all works in turn, `runs` times over, so that a temporary slowdown of the machine slows them all. Each is
/// repeated within a run until at least a tenth of a second has passed. `done`, if not null, counts the timings made,
/// works × runs in all.
Speeds time_in_turn(const std::vector<Work>& works, int runs, std::atomic<std::int64_t>* done = nullptr);

/// Nanoseconds per ray, from million rays per second.
std::vector<double> nanoseconds(std::vector<double> speeds);

/// How many times as fast `one` was as `other`, run by run.
Spread ratio(const std::vector<double>& one, const std::vector<double>& other);

}  // namespace glassbox
