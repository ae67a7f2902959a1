#include "render/measure/filled_channels.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace glassbox {

namespace {

std::vector<Channel> empty_channels(const Measurement& measurement, int width, int height) {
    const std::size_t pixels = pixel_count(width, height);
    std::vector<Channel> channels;
    for (const std::string_view name : measurement.channels())
        channels.push_back({std::string(name), width, height, std::vector<double>(pixels, no_value)});
    return channels;
}

bool has_value(const Channel& channel) {
    return !std::ranges::all_of(channel.values, [](double value) { return std::isnan(value); });
}

}  // namespace

FilledChannels::FilledChannels(const Scene& scene, std::span<const Measurement* const> wanted)
    : wanted_(wanted), reasons_(wanted.size()) {
    for (const Measurement* measurement : wanted)
        channels_.push_back(empty_channels(*measurement, scene.width, scene.height));
}

void FilledChannels::fill(Pixel pixel, const PixelNumbers& numbers, const Circumstances& how) {
    for (std::size_t m = 0; m < wanted_.size(); ++m) {
        reasons_[m].consider(why_no_value(*wanted_[m], numbers, how));
        const std::array<double, 3> values = wanted_[m]->read(numbers);
        for (std::size_t c = 0; c < channels_[m].size(); ++c) {
            Channel& channel = channels_[m][c];
            channel.values[index_of(pixel, channel.width)] = values[c];
        }
    }
}

std::vector<std::vector<Channel>> FilledChannels::filled(const Options& options) {
    for (std::size_t m = 0; m < wanted_.size(); ++m)
        for (Channel& channel : channels_[m])
            if (!has_value(channel)) channel.why_no_value = reason_text(reasons_[m].get(), *wanted_[m], options);
    return std::move(channels_);
}

}  // namespace glassbox
