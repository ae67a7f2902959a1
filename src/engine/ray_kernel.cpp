#include "engine/ray_kernel.hpp"

#include "engine/prefetch.hpp"
#include "engine/visits.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/ray_kernel.cpp"
#include <hwy/foreach_target.h>
// Highway's own order: the header comes after the loop over targets.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox::engine::HWY_NAMESPACE {

#include "engine/vectors.inl"

#include "engine/children_met.inl"
#include "engine/ray_triangles.inl"
#include "engine/sphere_roots.inl"

// Needs the last.
#include "engine/ray_spheres.inl"

/// Traces one ray by itself; with `Any`, only until something is surely met.
template <bool Any>
class RayKernel {
public:
    HWY_ATTR RayKernel(const Engine& engine, const BoxRay& ray, Candidates& found)
        : found_(found), engine_(engine), ray_(ray), sheared_(sheared(ray)) {}

    HWY_INLINE HWY_ATTR void operator()() {
        if (engine_.hierarchy().nodes.empty()) return;
        Visits visits({0, 0});
        while (true) {
            const std::uint32_t leaf = next_leaf(visits);
            if (leaf == Child::nothing) break;
            if (!visits.is_empty()) prefetch(engine_, visits.top().child);
            test(leaf);
            if (Any && found_.high < infinity) break;
        }
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// The leaf that the ray comes to next, or nothing.
    HWY_INLINE HWY_ATTR std::uint32_t next_leaf(Visits& visits) const {
        while (!visits.is_empty()) {
            auto [child, entry] = visits.pop();
            if (entry > t_max_) continue;
            while (!Child::is_leaf(child)) child = next_below(engine_.hierarchy().nodes[child], visits);
            if (child != Child::nothing) return child;
        }
        return Child::nothing;
    }

    /// The child of a node that the ray comes to first, or nothing; the others are left to be visited later.
    HWY_INLINE HWY_ATTR std::uint32_t next_below(const Node& node, Visits& visits) const {
        alignas(32) float entries[fan_out];
        const std::uint32_t met = children_met(node, ray_, t_max_, entries);
        if (met == 0) return Child::nothing;
        if (Any) return visits.push_all_but_one(node, met);  // sorting them would cost more than it saves
        if ((met & (met - 1)) == 0) return node.child[__builtin_ctz(met)];
        return visits.push_all_but_nearest(node, met, entries);
    }

    HWY_INLINE HWY_ATTR void test(std::uint32_t leaf) {
        if (Child::is_of_spheres(leaf)) return test_spheres(engine_.hierarchy().sphere_leaves[Child::index(leaf)]);
        const Block& block = engine_.blocks()[Child::index(leaf)];
        for_each_met(sheared_, block, [&](std::uint32_t at, bool sure, double low, double high) HWY_ATTR {
            add(block.surface[at], sure, low, high);
        });
    }

    HWY_NOINLINE HWY_ATTR void test_spheres(const Leaf& leaf) {
        const std::uint32_t* const numbers = engine_.hierarchy().surfaces.data() + leaf.first;
        for_each_met(ray_, engine_.scaled_spheres().data(), numbers, leaf.count,
                     [&](std::uint32_t at, bool sure, double low, double high)
                         HWY_ATTR { add(numbers[at], sure, low, high); });
    }

    /// Takes a surface that is met between two t, if at all.
    void add(std::uint32_t surface, bool sure, double low, double high) {
        if (low > found_.high) return;
        if (Any && sure) {  // nothing else matters
            found_.count = 1;
            found_.is_whole = true;
            found_.high = high;
            found_.list[0] = {surface, sure, low};
            return;
        }
        if (sure && high < found_.high) {
            found_.high = high;
            t_max_ = BoxRay::t_max_of(high);
            drop_what_lies_behind();
        }
        if (found_.count == Candidates::most) found_.is_whole = false;
        else found_.list[found_.count++] = {surface, sure, low};
    }

    void drop_what_lies_behind() {
        int kept = 0;
        for (int i = 0; i < found_.count; ++i)
            if (found_.list[i].low <= found_.high) found_.list[kept++] = found_.list[i];
        found_.count = kept;
    }

    Candidates& found_;
    const Engine& engine_;
    const BoxRay& ray_;
    ShearedRay sheared_;
    float t_max_ = std::numeric_limits<float>::infinity();
};

template <bool Any>
HWY_INLINE HWY_ATTR Candidates candidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes) {
    Candidates found;
    if (set_up(boxes, ray, engine)) RayKernel<Any>(engine, boxes, found)();
    else found.is_whole = false;
    return found;
}

HWY_ATTR Candidates FirstCandidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes) {
    return candidates<false>(engine, ray, boxes);
}

HWY_ATTR Candidates AnyCandidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes) {
    return candidates<true>(engine, ray, boxes);
}

}  // namespace glassbox::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glassbox::engine {

HWY_EXPORT(FirstCandidates);
HWY_EXPORT(AnyCandidates);

Candidates first_candidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes) {
    return HWY_DYNAMIC_DISPATCH(FirstCandidates)(engine, ray, boxes);
}

Candidates any_candidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes) {
    return HWY_DYNAMIC_DISPATCH(AnyCandidates)(engine, ray, boxes);
}

}  // namespace glassbox::engine
#endif
