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
#include "engine/ray_triangles.inl"

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

HWY_ATTR std::uint32_t NotMissed(const Block& block, const BoxRay& ray) {
    ShearedRay line = sheared(ray);
    line.from = -std::numeric_limits<double>::infinity();
    std::uint32_t result = 0;
    for_each_met(line, block, [&](std::uint32_t at, bool, double, double) { result |= 1u << at; });
    return result;
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

std::uint32_t not_missed(const Block& block, const BoxRay& ray) { return HWY_DYNAMIC_DISPATCH(NotMissed)(block, ray); }

const char* vectors_used() { return HWY_DYNAMIC_DISPATCH(VectorsUsed)(); }

}  // namespace glassbox::engine
#endif
