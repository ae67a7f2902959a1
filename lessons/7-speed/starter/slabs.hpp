#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <not_written.hpp>
#include <ray.hpp>

#include <box.hpp>

namespace glassbox::engine {

/// All t with enters ≤ t ≤ leaves; none where enters > leaves.
template <class Real>
struct Interval {
    Real enters, leaves;
};

template <class Real>
constexpr bool is_empty(const Interval<Real>& interval) {
    return !(interval.enters <= interval.leaves);
}

/// 1/D, axis by axis, computed once for all boxes that the ray is tested against: multiplying is cheaper than dividing.
/// It is infinite on an axis where D is 0.
template <class Real>
constexpr Vec3<Real> inverse(const Vec3<Real>& D) {
    return {Real(1) / D.x, Real(1) / D.y, Real(1) / D.z};
}

/// The t at which P + tD lies in the slab between lo and hi, on one axis: from (lo − P)/D to (hi − P)/D, or the other
/// way round where D < 0. A ray parallel to the slab, whose 1/D is infinite, lies in it always or never. The slab's
/// faces belong to it.
template <class Real>
constexpr Interval<Real> slab(Real lo, Real hi, Real P, Real inverse_D) {
    // Your turn: a ray along the slab; else its two crossings, the earlier one first
    return not_written<Interval<Real>>("slab");
}

/// A factor that covers rounding where an entry is compared with an exit. Each is rounded three times, in lo − P, in
/// 1/D and in their product, and so off by a factor between (1 − u)³ and (1 + u)³, u = ε/2. ((1 + u)/(1 − u))³ is less
/// than 1 + 7u; one more u covers the product with this factor itself. (Ize, "Robust BVH Ray Traversal", 2013.)
template <class Real>
constexpr Real widened = 1 + 4 * std::numeric_limits<Real>::epsilon();

/// The t ≥ 0 at which the ray from P is in the box, and so in all three slabs at once. Never empty where the true ray
/// meets the box, if no number overflows or underflows: the exit is `widened`.
template <class Real>
constexpr Interval<Real> through(const Box& box, const Vec3<Real>& P, const Vec3<Real>& inverse_D) {
    // Your turn: three slabs, the last entry, the first exit, widened
    return not_written<Interval<Real>>("through");
}

}  // namespace glassbox::engine
