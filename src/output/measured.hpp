#pragma once
#include <span>
#include <vector>

#include "render/measure/channel.hpp"
#include "render/measure/measurements.hpp"

namespace glassbox {

/// A measurement and its results: one channel per component.
struct Measured {
    const Measurement* what;
    std::span<const Channel> channels;
    SetSpacing spacing = {};  ///< of its colours; without it the measurement's own
};

/// The channels of all, in order.
inline std::vector<const Channel*> all_channels(std::span<const Measured> measured) {
    std::vector<const Channel*> channels;
    for (const Measured& m : measured)
        for (const Channel& channel : m.channels) channels.push_back(&channel);
    return channels;
}

}  // namespace glassbox
