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

#include "engine/children_met.inl"

/// A template, so that a traversal that nobody hears of box by box is compiled without the telling.
template <class Open>
HWY_INLINE HWY_ATTR TraversalCounts traverse_telling(const Hierarchy& hierarchy, const BoxRay& ray, float t_max,
                                                     VisitLeaf visit, const Open& open) {
    TraversalCounts counts;
    if (hierarchy.nodes.empty()) return counts;
    Visits visits({0, 0});
    while (!visits.is_empty()) {
        const auto [child, entry] = visits.pop();
        if (entry > t_max || child == Child::nothing) continue;
        open(child);
        if (Child::is_leaf(child)) {
            t_max = visit(child, t_max);
            continue;
        }
        const Node& node = hierarchy.nodes[child];
        alignas(32) float entries[fan_out];
        const std::uint32_t met = children_met(node, ray, t_max, entries);
        ++counts.nodes;
        counts.boxes_missed += static_cast<std::uint32_t>(fan_out - __builtin_popcount(met));
        visits.push(node, met, entries);
    }
    return counts;
}

HWY_ATTR TraversalCounts Traverse(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit) {
    return traverse_telling(hierarchy, ray, t_max, visit, [](std::uint32_t) HWY_ATTR {});
}

HWY_ATTR TraversalCounts TraverseTelling(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit,
                                         OpenBox open) {
    return traverse_telling(hierarchy, ray, t_max, visit, open);
}

/// Side products as in filter::sides_error: |ŝ − s| ≤ 8u S, and S ≤ 2m²(|D.x| + |D.y| + |D.z|), where m is the largest
/// coordinate of the vertices as seen from P; 20u for 16u covers the bound's own rounding, 2⁻⁹⁰⁰ any underflow. A start
/// that is off by δ changes s by |D|(4mδ + 2δ²) at most.
HWY_ATTR std::uint32_t NotMissed(const Block& block, const Ray<double>& ray, double start_error) {
    const Vec3<Doubles> P = broadcast(ray.P), D = broadcast(ray.D);
    const double D_size = std::abs(ray.D.x) + std::abs(ray.D.y) + std::abs(ray.D.z);
    const double by_rounding = 20 * 0x1p-53 * D_size, by_start = 6 * start_error * D_size;
    std::uint32_t result = 0;
    for (std::size_t at = 0; at < fan_out; at += Doubles::count()) {
        const Vec3<Doubles> A = load(block.A, at) - P, B = load(block.B, at) - P, C = load(block.C, at) - P;
        const Doubles a = side(D, B, C), b = side(D, C, A), c = side(D, A, B);
        const auto size = [](const Vec3<Doubles>& v) HWY_ATTR { return max(max(abs(v.x), abs(v.y)), abs(v.z)); };
        const Doubles m = max(max(size(A), size(B)), size(C));
        const Doubles error = by_rounding * m * m + by_start * (m + start_error) + 0x1p-900;
        const auto missed = (max(max(a, b), c) > error) & (min(min(a, b), c) < -error);
        result |= bits_of(!missed) << at;
    }
    return result & ((1u << block.count) - 1);
}

const char* VectorsUsed() { return hwy::TargetName(HWY_TARGET); }

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(Traverse);
HWY_EXPORT(TraverseTelling);
HWY_EXPORT(NotMissed);
HWY_EXPORT(VectorsUsed);

TraversalCounts traverse(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit) {
    return HWY_DYNAMIC_DISPATCH(Traverse)(hierarchy, ray, t_max, visit);
}

TraversalCounts traverse(const Hierarchy& hierarchy, const BoxRay& ray, float t_max, VisitLeaf visit, OpenBox open) {
    return HWY_DYNAMIC_DISPATCH(TraverseTelling)(hierarchy, ray, t_max, visit, open);
}

std::uint32_t not_missed(const Block& block, const Ray<double>& ray, double start_error) {
    return HWY_DYNAMIC_DISPATCH(NotMissed)(block, ray, start_error);
}

const char* vectors_used() { return HWY_DYNAMIC_DISPATCH(VectorsUsed)(); }

}  // namespace glassbox::engine
#endif
