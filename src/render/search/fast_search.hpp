#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "engine/kernels.hpp"
#include "engine/ray_kernel.hpp"
#include "render/search/filtered_predicates.hpp"
#include "render/search/probe_flags.hpp"

namespace glassbox {

namespace told {
struct NodesVisited {};  ///< (count): nodes of the hierarchy with their eight boxes tested
struct BoxesMissed {};   ///< (count): of these boxes, those missed by the ray or behind its nearest hit so far
struct BoxOpened {};     ///< (code): the walk visits the node or the leaf with that code (engine::Child)
}  // namespace told

/// A scene's surfaces in the engine. Computes bounds for a ray and a surface only on request: a ray comes near few
/// surfaces.
struct EngineSurfaces {
    std::shared_ptr<const engine::Engine> engine;

    template <class Use>
    auto with_surface(std::size_t number, const Use& use) const {
        return engine->with_surface(number, use);
    }
    template <class Surface>
    auto errors(const Surface& surface, std::size_t, const Ray<double>& ray) const {
        return errors_for(ray, surface);
    }
};

/// Finds the nearest hit with the same answers as CertifiedSearch. Tests only surfaces whose boxes the ray meets, and,
/// if the probe is OnlyNearest, none far behind the nearest hit so far.
///
/// A probe that listens to tests hears those that are made: of all surfaces in a leaf, each by the core's own formula.
/// For other probes, vector instructions first reject the surfaces that are surely missed.
class FastSearch {
public:
    using Number = double;

    FastSearch(std::shared_ptr<const engine::Engine> engine, const SphereRule& sphere_rule,
               const TriangleRule& triangle_rule)
        : predicates_({std::move(engine)}, sphere_rule, triangle_rule, false) {}

    const engine::Engine& engine() const { return *predicates_.store().engine; }

    /// `ray` must be valid.
    template <class Probe>
    std::optional<ProvenHit> trace_proven(const Ray<double>& ray, Probe& probe) const {
        if constexpr (OnlyFirstHit<Probe> && !HearsBoxes<Probe>) {
            engine::BoxRay boxes;
            const engine::Candidates found = engine::first_candidates(engine(), ray, boxes);
            if (found.is_told() && engine().loose().empty()) return proven(ray, boxes, found, probe);
            if (found.is_whole) return Traversal<Probe>{*this, ray, probe, &boxes, {}}.first_of(found);
        }
        const std::optional<engine::BoxRay> boxes = engine::box_ray(ray, engine());
        Traversal<Probe> way{*this, ray, probe, boxes ? &*boxes : nullptr, {}};
        if (!boxes) {
            for (std::size_t i = 0; i < engine().size(); ++i) way.test(i);
            return way.best;
        }
        for (const std::uint32_t surface : engine().loose()) way.test(surface);
        const engine::TraversalCounts counts = way.traverse();
        if constexpr (!OnlyVerdicts<Probe>) {
            probe(told::NodesVisited{}, counts.nodes);
            probe(told::BoxesMissed{}, counts.boxes_missed);
        }
        return way.best;
    }

    /// What a ray meets first, and between which t.
    struct Nearest {
        std::size_t surface;
        double low, high;
    };

    /// The same surface as trace_proven's, but t only as nearly as it takes to find it: mostly to some ten-millionths
    /// of how far the triangles of its leaf reach. Nothing if the ray meets nothing. `ray` must be valid.
    std::optional<Nearest> nearest(const Ray<double>& ray) const {
        engine::BoxRay boxes;
        const engine::Candidates found = engine::first_candidates(engine(), ray, boxes);
        if (!found.is_told() || !engine().loose().empty()) return nearest_proven(ray);
        if (found.count == 0) return {};
        return Nearest{found.list[0].surface, boxes.least_t(found.list[0].low), boxes.most_t(found.high)};
    }

    /// Whether the ray meets anything. `ray` must be valid.
    bool occluded(const Ray<double>& ray) const {
        const auto is_met = [&](std::uint32_t surface) { return predicates_.is_met(ray, surface); };
        engine::BoxRay boxes;
        const engine::Candidates found = engine::any_candidates(engine(), ray, boxes);
        if (!found.is_whole) {
            const Silent silent;
            return trace_proven(ray, silent).has_value();
        }
        if (std::any_of(found.list, found.list + found.count,
                        [&](const engine::Candidate& one) { return one.sure || is_met(one.surface); }))
            return true;
        return std::ranges::any_of(engine().loose(), is_met);
    }

    template <class Probe>
    std::optional<Hit<double>> trace(const Ray<double>& ray, Probe& probe) const {
        return nearest_hit(*this, ray, probe);
    }

    /// To ask about single surfaces.
    const FilteredPredicates<EngineSurfaces>& predicates() const { return predicates_; }

    /// A triangle's is the same at the engine's scale, where nothing overflows, unless something underflowed before.
    Vec3<double> normal_at(const Ray<double>& ray, const Hit<double>& hit) const {
        if (hit.surface < engine().sphere_count()) return predicates_.normal_at(ray, hit);
        const Triangle<double> scaled_one = engine().scaled_triangle(hit.surface);
        if (engine().scale() != 1 && !keeps_products(scaled_one)) return predicates_.normal_at(ray, hit);
        return predicates_.normal_at(ray, hit.t, scaled_one);
    }

private:
    /// Whether no product of two differences of its coordinates underflows, as the triangle was given: these are 0 or
    /// 2⁻⁴⁴⁰ at least, differences then 2⁻⁴⁹² or 0.
    bool keeps_products(const Triangle<double>& triangle) const {
        const double least = 0x1p-440 * engine().scale();
        const auto keeps = [&](double x) { return x == 0 || std::abs(x) >= least; };
        const auto all = [&](const Vec3<double>& v) { return keeps(v.x) && keeps(v.y) && keeps(v.z); };
        return all(triangle.A) && all(triangle.B) && all(triangle.C);
    }

    std::optional<Nearest> nearest_proven(const Ray<double>& ray) const {
        const Silent silent;
        const std::optional<ProvenHit> hit = trace_proven(ray, silent);
        if (!hit) return {};
        const Bounded t = predicates_.with_bound(ray, *hit).t;
        const double low = t.value - t.error, high = t.value + t.error;
        return Nearest{hit->surface, std::nextafter(low, -HUGE_VAL), std::nextafter(high, HUGE_VAL)};
    }

    /// What the engine says that the ray meets first, if anything.
    template <class Probe>
    std::optional<ProvenHit> proven(const Ray<double>& ray, const engine::BoxRay& boxes,
                                    const engine::Candidates& found, Probe& probe) const {
        if (found.count == 0) return {};
        const auto& [surface, sure, low] = found.list[0];
        if (!boxes.as_given) return predicates_.hit_of(ray, surface, probe);
        return predicates_.proven(ray, surface, boxes.least_t(low), boxes.most_t(found.high), probe);
    }

    /// One ray's traversal of the hierarchy.
    template <class Probe>
    struct Traversal {
        const FastSearch& search;
        const Ray<double>& ray;
        Probe& probe;
        const engine::BoxRay* boxes;
        std::optional<ProvenHit> best;

        void test(std::size_t surface) {
            search.engine().with_surface(
                surface, [&](const auto& shape) { search.predicates_.test(best, ray, shape, surface, probe); });
        }

        /// The first of those that the engine leaves open, and of those that it does not hold.
        std::optional<ProvenHit> first_of(const engine::Candidates& found) {
            for (int i = 0; i < found.count; ++i) search.predicates_.consider(best, ray, found.list[i].surface, probe);
            for (const std::uint32_t surface : search.engine().loose()) test(surface);
            return best;
        }

        float t_max() const {
            if (!OnlyNearest<Probe> || !best) return std::numeric_limits<float>::infinity();
            return boxes->t_max(best->farthest);
        }

        engine::TraversalCounts traverse() {
            const auto visit = [this](std::uint32_t leaf, float before) { return test_leaf(leaf, before); };
            const engine::Hierarchy& hierarchy = search.engine().hierarchy();
            if constexpr (HearsBoxes<Probe>)
                return engine::traverse(hierarchy, *boxes, t_max(), visit,
                                        [this](std::uint32_t code) { probe(told::BoxOpened{}, code); });
            else return engine::traverse(hierarchy, *boxes, t_max(), visit);
        }

        /// t_max from now on, where it was `before`.
        float test_leaf(std::uint32_t leaf, float before) {
            const std::optional<ProvenHit> known = best;
            test_all(leaf);
            const bool is_new = best && (!known || known->surface != best->surface);
            return is_new ? t_max() : before;
        }

        void test_all(std::uint32_t leaf) {
            const engine::Engine& all = search.engine();
            const std::uint32_t index = engine::Child::index(leaf);
            if (engine::Child::is_of_spheres(leaf)) {
                const auto [first, count] = all.hierarchy().sphere_leaves[index];
                for (std::uint32_t i = 0; i < count; ++i) {
                    test(all.hierarchy().surfaces[first + i]);
                    test_copies_of(all.hierarchy().surfaces[first + i]);
                }
                return;
            }
            const engine::Block& block = all.blocks()[index];
            if constexpr (OnlyVerdicts<Probe>) {
                for (std::uint32_t rest = engine::not_missed(block, *boxes); rest != 0; rest &= rest - 1) {
                    search.predicates_.consider(best, ray, block.surface[std::countr_zero(rest)], probe);
                    test_copies_of(block.surface[std::countr_zero(rest)]);
                }
            } else {
                for (std::uint32_t at = 0; at < block.count; ++at) {
                    test(block.surface[at]);
                    test_copies_of(block.surface[at]);
                }
            }
        }

        /// Nobody sees them; who wants all that the ray meets wants them, too.
        void test_copies_of(std::uint32_t surface) {
            if constexpr (!OnlyNearest<Probe>)
                for (const engine::Copy& copy : search.engine().copies_of(surface)) test(copy.surface);
        }
    };

    FilteredPredicates<EngineSurfaces> predicates_;
};

}  // namespace glassbox
