#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "output/coloring.hpp"
#include "output/value_words.hpp"

namespace glassbox {

/// How many values lie from `from` up to the next bin's `from`, which is excluded; the last bin includes its `to`.
struct Bin {
    double from, to;
    std::int64_t count = 0;
};

/// The values of a channel in bins, from the low end of its colours to the high end.
struct Histogram {
    std::vector<Bin> bins;  ///< as wide as each other on the bar; none where no value is finite
    bool whole = false;     ///< of whole numbers: a bin holds those from `from` to `to`, both included
    std::int64_t most = 0;  ///< in one bin

    /// Returns the bin of a value; none if it is not finite or lies outside.
    std::optional<std::size_t> bin_of(double value) const;
};

/// Makes at most that many bins; whole numbers are never split unevenly over them. Values below the colours' low end or
/// above the high end are in none.
Histogram histogram(const Channel& channel, const Summary& summary, const Coloring& coloring, int most_bins);

/// Everything that a legend shows of one channel.
struct Distribution {
    Summary summary;
    Coloring coloring;
    Outside outside;
    Histogram histogram;
    std::vector<ColorWord> words;  ///< the colours that stand beside the bar
};

/// Returns what the colours of a measured channel stand for, with the range and the spacing that the user has set.
Distribution distribution(const Measurement& what, const Channel& channel, const SetRange& set,
                          const SetSpacing& spacing = {});

/// The values of the bins from one to another, both included. The upper end of a bin belongs to the next.
std::pair<double, double> values_of(const Histogram& histogram, std::size_t first, std::size_t last);

}  // namespace glassbox
