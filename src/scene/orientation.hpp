#pragma once
#include <compare>

namespace glassbox {

/// A point of a plane. Points are ordered from left to right, then from bottom to top.
struct Point2 {
    double x, y;
    friend auto operator<=>(const Point2&, const Point2&) = default;
};

/// Which way a, b, c turn: 1 counter-clockwise, −1 clockwise, 0 if they lie on a line. Exact for all finite numbers.
int orientation(const Point2& a, const Point2& b, const Point2& c);

}  // namespace glassbox
