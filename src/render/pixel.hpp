#pragma once

namespace glassbox {

/// A pixel of a picture: (0, 0) is the top-left one.
struct Pixel {
    int x = 0, y = 0;

    bool operator==(const Pixel&) const = default;
};

}  // namespace glassbox
