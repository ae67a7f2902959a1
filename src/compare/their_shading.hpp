#pragma once
#include <algorithm>
#include <cmath>
#include <type_traits>

#include <shade_by_model.hpp>

#include "numerics/enclosure.hpp"

namespace glassbox {

// Where shading goes one of two ways, and rounding leaves open which, an enclosure holds what either gives. The core's
// formulas find these functions instead of their own.

/// max(0, x).
template <class Real>
Enclosure<Real> positive_part(const Enclosure<Real>& x) {
    const auto& [value, error] = x.range();
    if (!(value < error)) return x;  // surely positive, or nothing is known
    const double most = Bounded::up(value + error) / 2;
    return most > 0 ? Enclosure<Real>(Bounded(most, Bounded::up(most))) : Enclosure<Real>();
}

/// n or −n, and all between where the sign is open.
template <class Real>
Vec3<Enclosure<Real>> towards(const Vec3<Enclosure<Real>>& r, const Vec3<Enclosure<Real>>& n) {
    const Kleene away = dot(n, r) < Enclosure<Real>(0);
    if (surely(away)) return -n;
    if (!possibly(away)) return n;
    const auto both = [](const Enclosure<Real>& x) {
        return Enclosure<Real>(Bounded(0, Bounded::up(std::abs(x.range().value) + x.range().error)));
    };
    return {both(n.x), both(n.y), both(n.z)};
}

/// What a vector that was made a unit vector may be: whatever its direction comes to, no component is beyond 1 by more
/// than rounding.
template <class Real>
Vec3<Enclosure<Real>> within_unit(const Vec3<Enclosure<Real>>& n) {
    const auto cut = [](const Enclosure<Real>& x) {
        constexpr double most = 1 + 0x1p-10;
        const auto& [value, error] = x.range();
        if (!isfinite(x)) return Enclosure<Real>(Bounded(0, most));
        const double low = std::max(value - error, -most), high = std::min(value + error, most);
        if (!(low > value - error || high < value + error) || !(low <= high)) return x;
        const double middle = low / 2 + high / 2;
        return Enclosure<Real>(Bounded(middle, Bounded::up(high / 2 - low / 2 + Bounded::u * std::abs(middle))));
    };
    return {cut(n.x), cut(n.y), cut(n.z)};
}

/// Of any direction where the two may cancel.
template <class Real>
Vec3<Enclosure<Real>> halfway(const Vec3<Enclosure<Real>>& a, const Vec3<Enclosure<Real>>& b) {
    return within_unit(unit(a + b));
}

template <class Real>
Vec3<Enclosure<Real>> tinted(const std::type_identity_t<Enclosure<Real>>& strength,
                             const Vec3<Enclosure<Real>>& color) {
    return strength * color;
}

}  // namespace glassbox
