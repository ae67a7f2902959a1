#include "viewer/model/overlay/histogram.hpp"

#include <algorithm>
#include <cmath>

namespace glassbox {

namespace {

std::vector<Bin> whole_bins(double low, double high, int most) {
    const double each = std::ceil((high - low + 1) / most);
    std::vector<Bin> bins;
    for (double from = low; from <= high; from += each) bins.push_back({from, std::min(from + each - 1, high)});
    return bins;
}

std::vector<Bin> even_bins(const Coloring& coloring, int most) {
    if (coloring.low == coloring.high) return {{coloring.low, coloring.high}};
    const auto edge = [&](int k) { return coloring.value_at(static_cast<double>(k) / most); };
    std::vector<Bin> bins;
    for (int k = 0; k < most; ++k) bins.push_back({edge(k), edge(k + 1)});
    return bins;
}

}  // namespace

std::optional<std::size_t> Histogram::bin_of(double value) const {
    if (bins.empty() || !(value >= bins.front().from && value <= bins.back().to)) return {};
    const auto after =
        std::upper_bound(bins.begin(), bins.end(), value, [](double v, const Bin& bin) { return v < bin.from; });
    return static_cast<std::size_t>(after - bins.begin()) - 1;
}

Histogram histogram(const Channel& channel, const Summary& summary, const Coloring& coloring, int most_bins) {
    const auto [low, high] = std::pair(coloring.low, coloring.high);
    Histogram result;
    if (!summary.any_finite()) return result;
    // Beyond 2^53 a double cannot hold every whole number.
    result.whole = coloring.spacing == Spacing::linear && summary.whole && low == std::floor(low) &&
                   high == std::floor(high) && std::max(std::abs(low), std::abs(high)) < 0x1p53;
    result.bins = result.whole ? whole_bins(low, high, most_bins) : even_bins(coloring, most_bins);
    // As bins are even on the bar, a value's place there is near its bin: quicker than to search all of them.
    const std::size_t last = result.bins.size() - 1;
    for (const double value : channel.values) {
        if (!(value >= result.bins.front().from && value <= result.bins.back().to)) continue;
        std::size_t bin = std::min(
            last, static_cast<std::size_t>(coloring.position(value) * static_cast<double>(result.bins.size())));
        while (bin > 0 && value < result.bins[bin].from) --bin;
        while (bin < last && value >= result.bins[bin + 1].from) ++bin;
        ++result.bins[bin].count;
    }
    for (const Bin& bin : result.bins) result.most = std::max(result.most, bin.count);
    return result;
}

Distribution distribution(const Measurement& what, const Channel& channel, const SetRange& set,
                          const SetSpacing& spacing) {
    const Summary summary = summarized(channel, spacing_of(what, spacing));
    Coloring coloring = coloring_of(what, summary, what.scale == Scale::direction ? SetRange{} : set, spacing);
    if (what.scale == Scale::direction) coloring.blocks = false;  // its colours blend into each other
    const int most_bins = coloring.marks_0 ? 63 : 64;             // an odd number has a bin about 0
    Histogram bins = histogram(channel, summary, coloring, most_bins);
    std::vector<ColorWord> words = color_words(what, channel, summary, coloring);
    const Outside beyond = outside(channel, coloring);
    return {summary, std::move(coloring), beyond, std::move(bins), std::move(words)};
}

std::pair<double, double> values_of(const Histogram& histogram, std::size_t first, std::size_t last) {
    const std::vector<Bin>& bins = histogram.bins;
    const bool shares_end = !histogram.whole && last + 1 < bins.size();
    return {bins[first].from, shares_end ? std::nextafter(bins[last].to, -INFINITY) : bins[last].to};
}

}  // namespace glassbox
