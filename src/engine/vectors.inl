// Vectors of the kind that is being compiled for: to be included within a namespace of its own for each.

namespace hn = hwy::HWY_NAMESPACE;

// The core's own formulas, compiled here once more so that they may use this target's vectors.
#include "engine_formulas.inl"

/// A yes or no for each of several numbers. `D` is Highway's tag for these numbers: their type, and how many.
template <class D>
struct Mask {
    hn::Mask<D> m;

    HWY_ATTR Mask(hn::Mask<D> mask) : m(mask) {}

    friend HWY_ATTR Mask operator&(const Mask& a, const Mask& b) { return hn::And(a.m, b.m); }
    friend HWY_ATTR Mask operator|(const Mask& a, const Mask& b) { return hn::Or(a.m, b.m); }
    friend HWY_ATTR Mask operator!(const Mask& a) { return hn::Not(a.m); }

    friend HWY_ATTR bool none(const Mask& a) { return hn::AllFalse(D(), a.m); }
    /// A bit each, of up to 8.
    friend HWY_ATTR std::uint32_t bits_of(const Mask& a) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(D(), a.m, bytes);
        return bytes[0];
    }
};

/// Several numbers at once: a scalar to the core's formulas. A single number stands for as many of its like.
template <class D>
struct Numbers {
    using Tag = D;
    using One = hn::TFromD<D>;
    hn::Vec<D> v = hn::Zero(D());

    Numbers() = default;
    HWY_ATTR Numbers(hn::Vec<D> vector) : v(vector) {}
    HWY_ATTR Numbers(One one) : v(hn::Set(D(), one)) {}

    static HWY_ATTR std::size_t count() { return hn::Lanes(D()); }
    static HWY_ATTR Numbers load(const One* from) { return hn::Load(D(), from); }
    HWY_ATTR void store(One* to) const { hn::Store(v, D(), to); }

    friend HWY_ATTR Numbers operator+(const Numbers& a, const Numbers& b) { return hn::Add(a.v, b.v); }
    friend HWY_ATTR Numbers operator-(const Numbers& a, const Numbers& b) { return hn::Sub(a.v, b.v); }
    friend HWY_ATTR Numbers operator*(const Numbers& a, const Numbers& b) { return hn::Mul(a.v, b.v); }
    friend HWY_ATTR Numbers operator/(const Numbers& a, const Numbers& b) { return hn::Div(a.v, b.v); }
    friend HWY_ATTR Numbers operator-(const Numbers& a) { return hn::Neg(a.v); }

    friend HWY_ATTR Mask<D> operator<(const Numbers& a, const Numbers& b) { return hn::Lt(a.v, b.v); }
    friend HWY_ATTR Mask<D> operator>(const Numbers& a, const Numbers& b) { return hn::Gt(a.v, b.v); }
    friend HWY_ATTR Mask<D> operator<=(const Numbers& a, const Numbers& b) { return hn::Le(a.v, b.v); }
    friend HWY_ATTR Mask<D> operator>=(const Numbers& a, const Numbers& b) { return hn::Ge(a.v, b.v); }

    friend HWY_ATTR Numbers max(const Numbers& a, const Numbers& b) { return hn::Max(a.v, b.v); }
    friend HWY_ATTR Numbers min(const Numbers& a, const Numbers& b) { return hn::Min(a.v, b.v); }
    friend HWY_ATTR Numbers abs(const Numbers& a) { return hn::Abs(a.v); }
    friend HWY_ATTR Numbers sqrt(const Numbers& a) { return hn::Sqrt(a.v); }
    friend HWY_ATTR Numbers ceil(const Numbers& a) { return hn::Ceil(a.v); }
    friend HWY_ATTR Numbers floor(const Numbers& a) { return hn::Floor(a.v); }
    /// The size of a with the sign of b.
    friend HWY_ATTR Numbers copysign(const Numbers& a, const Numbers& b) { return hn::CopySign(a.v, b.v); }
    /// ab + c, rounded once or twice as the processor has it.
    friend HWY_ATTR Numbers multiply_add(const Numbers& a, const Numbers& b, const Numbers& c) {
        return hn::MulAdd(a.v, b.v, c.v);
    }
    /// c − ab, likewise.
    friend HWY_ATTR Numbers less_product(const Numbers& c, const Numbers& a, const Numbers& b) {
        return hn::NegMulAdd(a.v, b.v, c.v);
    }
    /// Where the mask says yes, a; elsewhere b.
    friend HWY_ATTR Numbers select(const Mask<D>& mask, const Numbers& a, const Numbers& b) {
        return hn::IfThenElse(mask.m, a.v, b.v);
    }
    friend HWY_ATTR One least_of_all(const Numbers& a) { return hn::GetLane(hn::MinOfLanes(D(), a.v)); }
};

using Doubles = Numbers<hn::CappedTag<double, fan_out>>;
/// A float for each of a node's children, or of a block's triangles.
using FanOfFloats = Numbers<hn::CappedTag<float, fan_out>>;

inline HWY_ATTR Vec3<Doubles> broadcast(const glassbox::Vec3<double>& a) {
    return {Doubles(a.x), Doubles(a.y), Doubles(a.z)};
}

inline HWY_ATTR Vec3<Doubles> load(const double (&from)[3][fan_out], std::size_t at) {
    return {Doubles::load(from[0] + at), Doubles::load(from[1] + at), Doubles::load(from[2] + at)};
}

inline HWY_ATTR Doubles load_as_doubles(const float* from) {
    return hn::PromoteTo(Doubles::Tag(), hn::Load(hn::Rebind<float, Doubles::Tag>(), from));
}

inline HWY_ATTR void store_as_floats(const Doubles& numbers, float* to) {
    const hn::Rebind<float, Doubles::Tag> f;
    hn::Store(hn::DemoteTo(f, numbers.v), f, to);
}
