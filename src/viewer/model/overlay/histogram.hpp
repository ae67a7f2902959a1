#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "output/coloring.hpp"

namespace glassbox {

/// How many values lie from `from` on and before the next bin's; the last one's `to` belongs to it, too.
struct Bin {
    double from, to;
    std::int64_t count = 0;
};

/// The values of a channel in bins from the low end of its colours to the high one.
struct Histogram {
    std::vector<Bin> bins;  ///< of the same width; none where no value is finite
    bool whole = false;     ///< of whole numbers: a bin holds those from `from` to `to`, both included
    std::int64_t most = 0;  ///< in one bin

    /// The bin of a value; none for what is not finite or lies outside.
    std::optional<std::size_t> bin_of(double value) const;
};

/// At most that many bins; whole numbers are never split unevenly over them. Values outside the colours' low and high
/// are in none.
Histogram histogram(const Channel& channel, const Summary& summary, const Coloring& coloring, int most_bins);

/// All that a legend tells of one channel.
struct Distribution {
    Summary summary;
    Coloring coloring;
    Outside outside;
    Histogram histogram;
};

/// What the colours of a measured channel stand for; `set` is a range that somebody set.
Distribution distribution(const Measurement& what, const Channel& channel, const SetRange& set);

}  // namespace glassbox
