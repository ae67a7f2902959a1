#include "viewer/model/overlay/finder.hpp"

#include <algorithm>
#include <cmath>

namespace glassbox {

namespace {

/// Of the values that `counts` accepts, those with the smallest `key(value)` first.
template <class Counts, class Key>
PixelList first_of(const Channel& channel, const Counts& counts, const Key& key) {
    struct Keyed {
        double key;
        std::size_t index;
        auto operator<=>(const Keyed&) const = default;
    };
    std::vector<Keyed> all;
    for (std::size_t i = 0; i < channel.values.size(); ++i)
        if (counts(channel.values[i])) all.push_back({key(channel.values[i]), i});
    PixelList list{{}, static_cast<std::int64_t>(all.size())};
    const auto listed = static_cast<std::ptrdiff_t>(std::min(all.size(), PixelList::most_listed));
    std::partial_sort(all.begin(), all.begin() + listed, all.end(),
                      [](const Keyed& a, const Keyed& b) { return a < b; });
    const auto width = static_cast<std::size_t>(channel.width);
    for (std::ptrdiff_t k = 0; k < listed; ++k) {
        const std::size_t index = all[static_cast<std::size_t>(k)].index;
        list.pixels.push_back({static_cast<int>(index % width), static_cast<int>(index / width)});
    }
    return list;
}

bool is_finite_value(double value) { return std::isfinite(value); }

}  // namespace

FoundPixels find_pixels(const Measurement& what, const Channel& channel) {
    // No order among words: reading order then.
    const auto badness = [&](double value) {
        if (!what.words.empty()) return 0.0;
        switch (what.worst) {
            case Worst::greatest:
                return -value;
            case Worst::least:
                return value;
            case Worst::nearest_0:
                return std::abs(value);
            case Worst::farthest_from_0:
                return value == 0 ? INFINITY : -std::abs(value);  // where nothing differs, nothing is bad
        }
        return value;
    };
    FoundPixels found;
    found.least = first_of(channel, is_finite_value, [](double value) { return value; });
    found.greatest = first_of(channel, is_finite_value, [](double value) { return -value; });
    found.alarming = first_of(
        channel, [&](double value) { return what.alarms(value); }, badness);
    const bool has_alarms = what.alarm == Alarm::above_0;
    found.worst =
        has_alarms
            ? found.alarming
            : first_of(
                  channel, [&](double value) { return !std::isnan(value) && badness(value) < INFINITY; }, badness);
    return found;
}

std::optional<std::size_t> next_worst(const PixelList& worst, const std::optional<Pixel>& from, bool forward) {
    const std::vector<Pixel>& all = worst.pixels;
    if (all.empty()) return {};
    const auto found = from ? std::ranges::find(all, *from) : all.end();
    if (found == all.end()) return forward ? 0 : all.size() - 1;
    const auto at = static_cast<std::size_t>(found - all.begin());
    return (at + (forward ? 1 : all.size() - 1)) % all.size();
}

}  // namespace glassbox
