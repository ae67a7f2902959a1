#include "engine/kernels.hpp"

#include "engine/visits.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/kernels.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

#include "engine/vectors.inl"

/// The children that the ray meets before `until`, and where it enters each.
HWY_ATTR std::uint32_t children_met(const Node& node, const BoxRay& ray, float until, float (&entries)[fan_out]) {
    const hn::CappedTag<float, fan_out> d;
    std::uint32_t met = 0;
    for (std::size_t at = 0; at < fan_out; at += hn::Lanes(d)) {
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

/// `open(child)` is told of each box that is looked into.
template <class Open>
HWY_INLINE HWY_ATTR void walk_telling(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit,
                                      void* state, WalkCounts& counts, const Open& open) {
    if (hierarchy.nodes.empty()) return;
    Visits visits({0, 0});
    while (!visits.is_empty()) {
        const auto [child, at] = visits.pop();
        if (at > until) continue;
        open(child);
        if (Child::is_leaf(child)) {
            until = visit(state, child, until);
            continue;
        }
        const Node& node = hierarchy.nodes[child];
        alignas(32) float entries[fan_out];
        const std::uint32_t met = children_met(node, ray, until, entries);
        ++counts.nodes;
        counts.boxes_missed += static_cast<std::uint32_t>(fan_out - __builtin_popcount(met));
        visits.push(node, met, entries);
    }
}

HWY_ATTR void Walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, void* state,
                   WalkCounts& counts) {
    walk_telling(hierarchy, ray, until, visit, state, counts, [](std::uint32_t) HWY_ATTR {});
}

HWY_ATTR void WalkToldOf(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, OpenBox open,
                         void* state, WalkCounts& counts) {
    walk_telling(hierarchy, ray, until, visit, state, counts,
                 [&](std::uint32_t child) HWY_ATTR { open(state, child); });
}

/// Side products as in filter::sides_error: |ŝ − s| ≤ 8u S, and S ≤ 2m²(|D.x| + |D.y| + |D.z|), where m is the largest
/// coordinate of the vertices as seen from P; 20u for 16u covers the bound's own rounding, 2⁻⁹⁰⁰ any underflow.
HWY_ATTR std::uint32_t NotMissed(const Block& block, const Ray<double>& ray) {
    const Doubles::Tag d;
    const Vec3<Doubles> P = broadcast(ray.P), D = broadcast(ray.D);
    const Doubles D_size(20 * 0x1p-53 * (std::abs(ray.D.x) + std::abs(ray.D.y) + std::abs(ray.D.z)));
    std::uint32_t result = 0;
    for (std::size_t at = 0; at < fan_out; at += hn::Lanes(d)) {
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
HWY_EXPORT(WalkToldOf);
HWY_EXPORT(NotMissed);
HWY_EXPORT(VectorsUsed);

void walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, void* state,
          WalkCounts& counts) {
    HWY_DYNAMIC_DISPATCH(Walk)(hierarchy, ray, until, visit, state, counts);
}

void walk(const Hierarchy& hierarchy, const BoxRay& ray, float until, VisitLeaf visit, OpenBox open, void* state,
          WalkCounts& counts) {
    HWY_DYNAMIC_DISPATCH(WalkToldOf)(hierarchy, ray, until, visit, open, state, counts);
}

std::uint32_t not_missed(const Block& block, const Ray<double>& ray) {
    return HWY_DYNAMIC_DISPATCH(NotMissed)(block, ray);
}

const char* vectors_used() { return HWY_DYNAMIC_DISPATCH(VectorsUsed)(); }

}  // namespace glassbox::engine
#endif
