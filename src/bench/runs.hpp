#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace glassbox {

/// The least, the middle and the greatest of several numbers.
struct Spread {
    double least, median, greatest;
};

/// At least one number is needed.
Spread spread(std::vector<double> numbers);

/// "1.15 (1.1 ... 1.23)": the middle one, the least and the greatest.
std::string to_text(const Spread& spread);

/// Work to be timed: what it is called, how many rays it traces, and itself.
struct Work {
    std::string name;
    double rays;
    std::function<void()> run;
};

/// Million rays a second of each work in each run.
using Speeds = std::vector<std::vector<double>>;

/// Times all works in turn, `runs` times over: what slows the machine down for a while slows them all. Each is repeated
/// within a run until at least a tenth of a second has passed. `done` counts the timings made, works × runs in all, if
/// anyone watches.
Speeds time_in_turn(const std::vector<Work>& works, int runs, std::atomic<std::int64_t>* done = nullptr);

/// How many times as fast the one was as the other, run by run.
Spread ratio(const std::vector<double>& one, const std::vector<double>& other);

}  // namespace glassbox
