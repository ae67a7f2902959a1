// Vectors of the kind that is being compiled for: to be included within a namespace of its own for each.

namespace hn = hwy::HWY_NAMESPACE;

// The core's own formulas, compiled here once more so that they may use this target's vectors.
#include "engine_formulas.inl"

/// Several doubles at once: a scalar to the core's formulas.
struct Doubles {
    using Tag = hn::CappedTag<double, fan_out>;
    using V = hn::Vec<Tag>;
    V v = hn::Zero(Tag());

    Doubles() = default;
    HWY_ATTR Doubles(V vector) : v(vector) {}
    HWY_ATTR explicit Doubles(double one) : v(hn::Set(Tag(), one)) {}

    friend HWY_ATTR Doubles operator+(const Doubles& a, const Doubles& b) { return hn::Add(a.v, b.v); }
    friend HWY_ATTR Doubles operator-(const Doubles& a, const Doubles& b) { return hn::Sub(a.v, b.v); }
    friend HWY_ATTR Doubles operator*(const Doubles& a, const Doubles& b) { return hn::Mul(a.v, b.v); }
    friend HWY_ATTR Doubles operator-(const Doubles& a) { return hn::Neg(a.v); }
};

inline HWY_ATTR Doubles max(const Doubles& a, const Doubles& b) { return hn::Max(a.v, b.v); }
inline HWY_ATTR Doubles min(const Doubles& a, const Doubles& b) { return hn::Min(a.v, b.v); }
inline HWY_ATTR Doubles abs(const Doubles& a) { return hn::Abs(a.v); }

inline HWY_ATTR Vec3<Doubles> broadcast(const glassbox::Vec3<double>& a) {
    return {Doubles(a.x), Doubles(a.y), Doubles(a.z)};
}

inline HWY_ATTR Vec3<Doubles> load(const double (&from)[3][fan_out], std::size_t at) {
    const Doubles::Tag d;
    return {hn::Load(d, from[0] + at), hn::Load(d, from[1] + at), hn::Load(d, from[2] + at)};
}

/// The bits of a mask of up to 8 lanes.
template <class Tag, class Mask>
HWY_ATTR std::uint32_t bits_of(Tag tag, Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(tag, mask, bytes);
    return bytes[0];
}
