#include "engine/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The core's own formulas, compiled here once more so that they may use this target's vectors.
#include "engine_formulas.inl"

/// Several doubles at once: a scalar to the core's formulas.
struct Doubles {
    using Tag = hn::CappedTag<double, width>;
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

HWY_ATTR Doubles max(const Doubles& a, const Doubles& b) { return hn::Max(a.v, b.v); }
HWY_ATTR Doubles min(const Doubles& a, const Doubles& b) { return hn::Min(a.v, b.v); }
HWY_ATTR Doubles abs(const Doubles& a) { return hn::Abs(a.v); }

HWY_ATTR Vec3<Doubles> broadcast(const glassbox::Vec3<double>& a) { return {Doubles(a.x), Doubles(a.y), Doubles(a.z)}; }

HWY_ATTR Vec3<Doubles> load(const double (&from)[3][width], std::size_t at) {
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

/// A place to go to, and where the ray gets there.
struct Visit {
    std::uint32_t child;
    float entry;
};

/// The children that the ray meets before `until`, and where it enters each.
HWY_ATTR std::uint32_t children_met(const Node& node, const BoxRay& ray, float until, float (&entries)[width]) {
    const hn::CappedTag<float, width> d;
    std::uint32_t met = 0;
    for (std::size_t at = 0; at < width; at += hn::Lanes(d)) {
        auto entry = hn::Zero(d);
        auto exit = hn::Set(d, until);
        for (int k = 0; k < 3; ++k) {
            const auto lo = hn::Load(d, node.lo[k] + at), hi = hn::Load(d, node.hi[k] + at);
            const auto inverse = hn::Set(d, ray.inverse[k]);
            const auto nearer = ray.backwards[k] ? hi : lo, farther = ray.backwards[k] ? lo : hi;
            entry = hn::Max(entry, hn::Mul(hn::Sub(nearer, hn::Set(d, ray.near_from[k])), inverse));
            const auto leaves = hn::Mul(hn::Sub(farther, hn::Set(d, ray.far_from[k])), inverse);
            exit = hn::Min(exit, hn::Mul(leaves, hn::Set(d, BoxRay::exit_factor)));
        }
        hn::StoreU(entry, d, entries + at);
        met |= bits_of(d, hn::Le(entry, hn::Add(exit, hn::Set(d, 0x1p-100f)))) << at;
    }
    return met;
}

HWY_ATTR void Walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, void* state,
                   WalkCounts& counts) {
    if (hierarchy.nodes.empty()) return;
    Visit stack[(width - 1) * most_levels + width];
    std::size_t depth = 0;
    stack[depth++] = {0, 0};
    while (depth > 0) {
        const auto [child, at] = stack[--depth];
        if (at > until) continue;
        if (Child::is_leaf(child)) {
            until = visit(state, child, until);
            continue;
        }
        const Node& node = hierarchy.nodes[child];
        alignas(32) float entries[width];
        std::uint32_t met = children_met(node, ray, until, entries);
        ++counts.nodes;
        counts.boxes_missed += static_cast<std::uint32_t>(width - __builtin_popcount(met));
        const std::size_t first = depth;
        for (; met != 0; met &= met - 1) {
            const auto i = static_cast<std::uint32_t>(__builtin_ctz(met));
            const Visit one{node.child[i], entries[i]};
            // The nearest is to lie on top.
            std::size_t place = depth++;
            for (; place > first && stack[place - 1].entry < one.entry; --place) stack[place] = stack[place - 1];
            stack[place] = one;
        }
    }
}

/// Side products as in filter::sides_error: |ŝ − s| ≤ 8u S, and S ≤ 2m²(|D.x| + |D.y| + |D.z|), where m is the largest
/// coordinate of the vertices as seen from P; 20u for 16u covers the bound's own rounding, 2⁻⁹⁰⁰ any underflow.
HWY_ATTR std::uint32_t NotMissed(const Block& block, const Ray<double>& ray) {
    const Doubles::Tag d;
    const Vec3<Doubles> P = broadcast(ray.P), D = broadcast(ray.D);
    const Doubles D_size(20 * 0x1p-53 * (std::abs(ray.D.x) + std::abs(ray.D.y) + std::abs(ray.D.z)));
    std::uint32_t result = 0;
    for (std::size_t at = 0; at < width; at += hn::Lanes(d)) {
        const Vec3<Doubles> A = load(block.A, at) - P, B = load(block.B, at) - P, C = load(block.C, at) - P;
        const Doubles a = side(D, B, C), b = side(D, C, A), c = side(D, A, B);
        const auto size = [](const Vec3<Doubles>& v) HWY_ATTR { return max(max(abs(v.x), abs(v.y)), abs(v.z)); };
        const Doubles m = max(max(size(A), size(B)), size(C));
        const Doubles error = D_size * m * m + Doubles(0x1p-900);
        const Doubles most = max(max(a, b), c), least = min(min(a, b), c);
        const auto missed = hn::And(hn::Gt(most.v, error.v), hn::Lt(least.v, (-error).v));
        result |= bits_of(d, hn::Not(missed)) << at;
    }
    return result & ((1u << block.count) - 1);
}

const char* VectorsUsed() { return hwy::TargetName(HWY_TARGET); }

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(Walk);
HWY_EXPORT(NotMissed);
HWY_EXPORT(VectorsUsed);

void walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, void* state,
          WalkCounts& counts) {
    HWY_DYNAMIC_DISPATCH(Walk)(hierarchy, ray, until, visit, state, counts);
}

std::uint32_t not_missed(const Block& block, const Ray<double>& ray) {
    return HWY_DYNAMIC_DISPATCH(NotMissed)(block, ray);
}

const char* vectors_used() { return HWY_DYNAMIC_DISPATCH(VectorsUsed)(); }

}  // namespace glassbox::engine
#endif
