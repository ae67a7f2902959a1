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

/// 1/D, axis by axis, found once for all boxes that the ray is tested against: a product is cheaper than a quotient. It
/// is infinite along an axis where D is 0.
template <class Real>
constexpr Vec3<Real> inverse(const Vec3<Real>& D) {
    return {Real(1) / D.x, Real(1) / D.y, Real(1) / D.z};
}

/// When P + tD lies in the slab between lo and hi, along one axis: from (lo − P)/D to (hi − P)/D, or the other way
/// round where D is below 0. A ray along the slab, whose 1/D is infinite, lies in it always or never; what lies on its
/// faces belongs to it.
template <class Real>
constexpr Interval<Real> slab(Real lo, Real hi, Real P, Real inverse_D) {
    // Your turn: a ray along the slab; else its two crossings, the earlier one first
    return not_written<Interval<Real>>("slab");
}

/// Makes good for rounding where an entry is compared with an exit. Each is rounded three times, in lo − P, in 1/D and
/// in their product, and so off by a factor between (1 − u)³ and (1 + u)³, u = ε/2. ((1 + u)/(1 − u))³ is less than
/// 1 + 7u, and u more is for the product with this factor itself. (Ize, "Robust BVH Ray Traversal", 2013.)
template <class Real>
constexpr Real widened = 1 + 4 * std::numeric_limits<Real>::epsilon();

/// When the ray from P is in the box, t ≥ 0: it has to be in all three slabs at once. It is never empty where the true
/// ray meets the box, if none of the numbers overflows or underflows: the exit is `widened`.
template <class Real>
constexpr Interval<Real> through(const Box& box, const Vec3<Real>& P, const Vec3<Real>& inverse_D) {
    // Your turn: three slabs, the last entry, the first exit, widened
    return not_written<Interval<Real>>("through");
}

}  // namespace glassbox::engine
