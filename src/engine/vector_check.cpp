#include "engine/vector_check.hpp"

#include <cmath>
#include <cstdint>
#include <random>

#include <pluecker.hpp>

#include "engine/vector_trial.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/vector_check.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

#include "engine/vectors.inl"

HWY_ATTR void Compute(const Operands& o, Results& r) {
    const Doubles::Tag d;
    const Vec3<Doubles> D{Doubles(o.D[0]), Doubles(o.D[1]), Doubles(o.D[2])};
    for (std::size_t at = 0; at < fan_out; at += hn::Lanes(d)) {
        const auto x = hn::Load(d, o.x + at), y = hn::Load(d, o.y + at);
        hn::Store(side(D, load(o.A, at), load(o.B, at)).v, d, r.side + at);
        hn::Store(hn::Div(x, y), d, r.quotient + at);
        hn::Store(hn::Sqrt(hn::Abs(x)), d, r.root + at);
    }
    const hn::CappedTag<float, fan_out> f;
    for (std::size_t at = 0; at < fan_out; at += hn::Lanes(f)) {
        const auto u = hn::Load(f, o.u + at), v = hn::Load(f, o.v + at), w = hn::Load(f, o.w + at);
        hn::Store(hn::Mul(u, v), f, r.product + at);
        hn::Store(hn::Mul(hn::Sub(u, v), w), f, r.distance + at);
        hn::Store(hn::Div(u, v), f, r.quotient_in_float + at);
        hn::Store(hn::MulAdd(u, v, w), f, r.fused + at);
    }
}

const char* KindInUse() { return hwy::TargetName(HWY_TARGET); }

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(Compute);
HWY_EXPORT(KindInUse);

namespace {

Results one_at_a_time(const Operands& o) {
    Results r;
    const Vec3<double> D{o.D[0], o.D[1], o.D[2]};
    for (std::size_t k = 0; k < fan_out; ++k) {
        r.side[k] = side(D, {o.A[0][k], o.A[1][k], o.A[2][k]}, {o.B[0][k], o.B[1][k], o.B[2][k]});
        r.quotient[k] = o.x[k] / o.y[k];
        r.root[k] = std::sqrt(std::abs(o.x[k]));
        r.product[k] = o.u[k] * o.v[k];
        r.distance[k] = (o.u[k] - o.v[k]) * o.w[k];
        r.quotient_in_float[k] = o.u[k] / o.v[k];
        r.fused[k] = std::fma(o.u[k], o.v[k], o.w[k]);
    }
    return r;
}

/// A product and a sum may be rounded once or twice: the tiles' bounds allow for either.
Results with_sums_rounded_twice(const Results& plain, const Operands& o) {
    Results r = plain;
    for (std::size_t k = 0; k < fan_out; ++k) r.fused[k] = r.product[k] + o.w[k];
    return r;
}

/// Ordinary numbers, and every fourth time such that products and quotients are below the normal ones.
Operands operands(int trial) {
    std::mt19937_64 bits(static_cast<std::uint64_t>(trial));
    const bool tiny = trial % 4 == 3;
    const auto number = [&] { return static_cast<double>(static_cast<std::int64_t>(bits())) * 0x1p-62; };
    const auto in_double = [&] { return tiny ? number() * 0x1p-345 : number(); };  // D·(B × A) near 2^-1035
    const auto in_float = [&] { return static_cast<float>(tiny ? number() * 0x1p-68 : number()); };
    Operands o;
    for (auto* row : {o.A[0], o.A[1], o.A[2], o.B[0], o.B[1], o.B[2]})
        for (std::size_t k = 0; k < fan_out; ++k) row[k] = in_double();
    for (double& component : o.D) component = in_double();
    for (std::size_t k = 0; k < fan_out; ++k) {
        o.x[k] = tiny ? number() * 0x1p-1030 : number();
        o.y[k] = number();
        o.u[k] = in_float();
        o.v[k] = in_float();
        o.w[k] = tiny ? static_cast<float>(number()) * 0x1p-80f : in_float();
    }
    return o;
}

bool computes_the_same_bits() {
    for (int trial = 0; trial < 100; ++trial) {
        const Operands o = operands(trial);
        Results by_vectors;
        HWY_DYNAMIC_DISPATCH(Compute)(o, by_vectors);
        const Results plain = one_at_a_time(o);
        if (!(by_vectors == plain) && !(by_vectors == with_sums_rounded_twice(plain, o))) return false;
    }
    return true;
}

void choose_among(std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

std::vector<VectorKind> try_vectors() {
    std::vector<VectorKind> kinds;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        choose_among(target);
        kinds.push_back({HWY_DYNAMIC_DISPATCH(KindInUse)(), computes_the_same_bits()});
    }
    choose_among(0);  // all, as it was
    return kinds;
}

}  // namespace glassbox::engine
#endif
