#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <sides.hpp>
#include <sphere.hpp>

namespace glassbox::engine {

/// The largest float that is not above x.
inline float rounded_down(double x) {
    const auto f = static_cast<float>(x);
    if (!(static_cast<double>(f) > x)) return f;
    // The float before f, like std::nextafter, but without a call and special cases.
    if (f == 0) return -std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::uint32_t>(f);
    return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}

/// The smallest float that is not below x.
inline float rounded_up(double x) { return -rounded_down(-x); }

/// An axis-aligned box between two corners. The empty box has lo > hi.
struct Box {
    static constexpr float inf = std::numeric_limits<float>::infinity();

    float lo[3] = {inf, inf, inf}, hi[3] = {-inf, -inf, -inf};

    /// Extends the box to hold another one.
    void add(const Box& other) {
        for (int k = 0; k < 3; ++k) {
            lo[k] = std::min(lo[k], other.lo[k]);
            hi[k] = std::max(hi[k], other.hi[k]);
        }
    }

    /// Twice the centre's coordinate on an axis.
    float middle2(int axis) const { return lo[axis] + hi[axis]; }

    /// Half the surface area; 0 for the empty box.
    float half_area() const {
        const float x = hi[0] - lo[0], y = hi[1] - lo[1], z = hi[2] - lo[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }

    /// Half the longest edge of the smallest box centred at the origin that holds this one.
    float reach() const {
        float most = 0;
        for (int k = 0; k < 3; ++k) most = std::max({most, -lo[k], hi[k]});
        return most;
    }
};

// Boxes are relative to a middle, so floats suffice however far away the surfaces lie. x − middle is rounded by at most
// u|x − middle|, u = 2⁻⁵³: each side moves outwards by at least twice that, then to the next float outwards.

inline void add_interval(Box& box, int axis, double lo, double hi) {
    box.lo[axis] = std::min(box.lo[axis], rounded_down(lo - std::abs(lo) * 0x1p-51));
    box.hi[axis] = std::max(box.hi[axis], rounded_up(hi + std::abs(hi) * 0x1p-51));
}

/// The box around a triangle, relative to `middle`.
inline Box box_of(const Triangle<double>& triangle, const Vec3<double>& middle) {
    const auto& [A, B, C] = seen_from(middle, triangle);
    Box box;
    const auto add = [&](int axis, double a, double b, double c) {
        add_interval(box, axis, std::min({a, b, c}), std::max({a, b, c}));
    };
    add(0, A.x, B.x, C.x);
    add(1, A.y, B.y, C.y);
    add(2, A.z, B.z, C.z);
    return box;
}

/// The box around a sphere, relative to `middle`. c ± r is rounded once more, by at most u(|c| + r).
inline Box box_of(const Sphere<double>& sphere, const Vec3<double>& middle) {
    const Vec3<double> c = sphere.C - middle;
    Box box;
    const auto add = [&](int axis, double at) {
        const double r = sphere.r + (std::abs(at) + sphere.r) * 0x1p-51;
        add_interval(box, axis, at - r, at + r);
    };
    add(0, c.x);
    add(1, c.y);
    add(2, c.z);
    return box;
}

}  // namespace glassbox::engine
