#pragma once
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

/// Of no known direction where the two may cancel.
template <class Real>
Vec3<Enclosure<Real>> halfway(const Vec3<Enclosure<Real>>& a, const Vec3<Enclosure<Real>>& b) {
    return unit(a + b);
}

template <class Real>
Vec3<Enclosure<Real>> tinted(const std::type_identity_t<Enclosure<Real>>& strength,
                             const Vec3<Enclosure<Real>>& color) {
    return strength * color;
}

}  // namespace glassbox
