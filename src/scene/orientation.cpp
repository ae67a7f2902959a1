#include "scene/orientation.hpp"

#include <cmath>

#include "numerics/dyadic.hpp"

namespace glassbox {
namespace {

int exact_orientation(const Point2& a, const Point2& b, const Point2& c) {
    const Dyadic ax(a.x), ay(a.y);
    return ((Dyadic(b.x) - ax) * (Dyadic(c.y) - ay) - (Dyadic(b.y) - ay) * (Dyadic(c.x) - ax)).sign();
}

}  // namespace

int orientation(const Point2& a, const Point2& b, const Point2& c) {
    const double abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
    // Points at one place, or aligned with an axis, are common; a difference is 0 only for equal numbers.
    if (((abx == 0 || acy == 0) && (aby == 0 || acx == 0)) || b == c) return 0;
    const double one = abx * acy, other = aby * acx, area = one - other;
    // Each difference, product and the last difference is rounded by u = 2⁻⁵³ at most: together 3u + O(u²) of the
    // products' sum (Shewchuk 1997), and a product that underflows by 2⁻¹⁰⁷⁵. After an overflow neither comparison
    // holds.
    const double doubt = 0x1p-51 * (std::abs(one) + std::abs(other)) + 0x1p-1021;
    if (area > doubt) return 1;
    if (area < -doubt) return -1;
    return exact_orientation(a, b, c);
}

}  // namespace glassbox
