#include "render/measure/reference_search.hpp"

#include <algorithm>

#include <bounded.hpp>

#include "engine/kernels.hpp"
#include "numerics/bits_lost.hpp"
#include "render/search/exact_crossing.hpp"

namespace glassbox {

namespace {

const Stable& rule_for(const Sphere<double>&) {
    static constexpr Stable rule;
    return rule;
}
const Pluecker& rule_for(const Triangle<double>&) {
    static constexpr Pluecker rule;
    return rule;
}

int in_order(const TrueT& a, const TrueT& b) { return compare(a, b); }

/// Tests one ray's surfaces, one after the other.
class ExhaustiveSearch {
public:
    ExhaustiveSearch(const engine::Engine& engine, const Ray<double>& ray)
        : engine_(engine), ray_(ray), bounded_(convert<Bounded>(ray)) {}

    void ask(std::size_t surface) {
        engine_.with_surface(surface, [&](const auto& shape) {
            const Silent silent;
            const Crossing<Bounded> crossing = intersect(bounded_, convert<Bounded>(shape), rule_for(shape), silent);
            if (!possibly(crossing.met)) return;
            std::optional<TrueT> t;
            if (!surely(crossing.met)) {
                needed_exact_ = true;
                t = exact_crossing(ray_, shape, rule_for(shape));
                if (!t) return;
            }
            met_.push_back(surface);
            // Where bounds left open whether it is met, they left open which root counts, too.
            const Met met{surface, t ? t->to_bounded() : crossing.t, t};
            if (!nearest_ || is_before(met, *nearest_)) nearest_ = met;
        });
    }

    struct Met {
        std::size_t surface;
        Bounded t;
        std::optional<TrueT> exact;
    };

    const std::vector<std::size_t>& met() const { return met_; }
    const std::optional<Met>& nearest() const { return nearest_; }
    bool needed_exact() const { return needed_exact_; }

    TrueT exact_t(const Met& met) const {
        if (met.exact) return *met.exact;
        return *engine_.with_surface(met.surface,
                                     [&](const auto& shape) { return exact_crossing(ray_, shape, rule_for(shape)); });
    }

private:
    /// Whether the ray meets `one` before `other`.
    bool is_before(const Met& one, const Met& other) {
        if (surely(one.t < other.t)) return true;
        if (surely(one.t > other.t)) return false;
        needed_exact_ = true;
        const int order = compare(exact_t(one), exact_t(other));
        return order != 0 ? order < 0 : one.surface > other.surface;
    }

    const engine::Engine& engine_;
    const Ray<double>& ray_;
    Ray<Bounded> bounded_;
    std::optional<Met> nearest_;
    std::vector<std::size_t> met_;
    bool needed_exact_ = false;
};

/// How many bits a t found in that scalar has lost.
double lost(long double t, const Exact& truth, Scalar scalar) {
    if (scalar == Scalar::float_) return bits_lost(static_cast<float>(t), truth);
    if (scalar == Scalar::long_double) return bits_lost(t, truth);
    return bits_lost(static_cast<double>(t), truth);
}

/// `ray` must be valid, and outlive the result.
ExhaustiveSearch searched(const ReferenceSearch& reference, const engine::Engine& engine, const Ray<double>& ray) {
    ExhaustiveSearch search(engine, ray);
    reference.for_each_tested(ray, [&](std::size_t surface) { search.ask(surface); });
    return search;
}

}  // namespace

Verdict verdict(const std::optional<std::size_t>& found, const std::optional<std::size_t>& truth) {
    if (found == truth) return Verdict::right;
    if (!truth) return Verdict::wrong_hit;
    return found ? Verdict::wrong_surface : Verdict::wrong_miss;
}

bool TrueHits::has(std::size_t surface) const { return std::binary_search(met.begin(), met.end(), surface); }

void ReferenceSearch::for_each_tested(const Ray<double>& ray, engine::FunctionRef<void(std::size_t)> ask) const {
    const std::optional<engine::BoxRay> boxes = engine_->size() <= few ? std::nullopt : engine::box_ray(ray, *engine_);
    if (!boxes) {
        for (std::size_t surface = 0; surface < engine_->size(); ++surface) ask(surface);
        return;
    }
    for (const std::uint32_t surface : engine_->loose()) ask(surface);
    const engine::Hierarchy& hierarchy = engine_->hierarchy();
    const auto ask_leaf = [&](std::uint32_t leaf, float t_max) {
        const auto& leaves = engine::Child::is_of_spheres(leaf) ? hierarchy.sphere_leaves : hierarchy.triangle_leaves;
        const auto [first, count] = leaves[engine::Child::index(leaf)];
        for (std::uint32_t i = first; i < first + count; ++i) {
            ask(hierarchy.surfaces[i]);
            for (const engine::Copy& copy : engine_->copies_of(hierarchy.surfaces[i])) ask(copy.surface);
        }
        return t_max;  // on to the end: all hits are wanted
    };
    engine::traverse(hierarchy, *boxes, std::numeric_limits<float>::infinity(), ask_leaf);
}

TrueHits ReferenceSearch::hits(const Ray<double>& ray) const {
    if (!is_valid(ray)) return {};
    const ExhaustiveSearch search = searched(*this, *engine_, ray);
    TrueHits result{search.met(), {}, search.needed_exact()};
    std::sort(result.met.begin(), result.met.end());
    if (search.nearest()) result.nearest = search.nearest()->surface;
    return result;
}

int ReferenceSearch::order(const Ray<double>& ray, std::size_t one, std::size_t other) const {
    const auto t = [&](std::size_t surface) {
        return engine_->with_surface(surface,
                                     [&](const auto& shape) { return *exact_crossing(ray, shape, rule_for(shape)); });
    };
    return in_order(t(one), t(other));
}

void ReferenceSearch::compare(const Ray<double>& ray, Scalar scalar, PixelNumbers& numbers) const {
    if (!is_valid(ray)) return;
    const ExhaustiveSearch search = searched(*this, *engine_, ray);
    const auto& nearest = search.nearest();
    const Verdict found = verdict(numbers.surface, nearest ? std::optional(nearest->surface) : std::nullopt);
    numbers.verdict = static_cast<double>(found);
    if (nearest && found == Verdict::right)
        numbers.bits_lost = lost(numbers.found_t, search.exact_t(*nearest).exact(), scalar);
}

}  // namespace glassbox
