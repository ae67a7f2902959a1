#pragma once
#include <cstdint>

#include "render/image.hpp"

namespace glassbox {

/// How two pictures of the same size differ.
struct Difference {
    Image magnified;  ///< each channel's difference, `magnification` times as bright; black where they are equal
    std::int64_t pixels = 0;  ///< that differ
    int greatest = 0;         ///< of all channels of all pixels, of 255
    Pixel where{};            ///< the first pixel with the greatest

    static constexpr int magnification = 8;
};

Difference picture_difference(const Image& one, const Image& other);

}  // namespace glassbox
