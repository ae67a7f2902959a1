#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"

namespace glassbox {

/// Pixels with something in common: the first of them, and how many there are.
struct PixelList {
    std::vector<Pixel> pixels;  ///< `most_listed` at most
    std::int64_t count = 0;

    static constexpr std::size_t most_listed = 1000;
};

/// Pixels that are worth a look. Equal ones are in reading order.
struct FoundPixels {
    PixelList worst;            ///< worst first: those that raise an alarm, or of a measurement without alarms all
    PixelList least, greatest;  ///< of the finite values, the least first, the greatest first
    PixelList alarming;         ///< that are wrong or not decided, worst first
};

/// Looks through all values. What is worst is for the measurement to say.
FoundPixels find_pixels(const Measurement& what, const Channel& channel);

/// The place among the worst after `from`, or before it; the first, or the last, where `from` is none of them. None
/// where there are none.
std::optional<std::size_t> next_worst(const PixelList& worst, const std::optional<Pixel>& from, bool forward);

}  // namespace glassbox
