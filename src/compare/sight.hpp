#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compare/cause.hpp"
#include "compare/possible.hpp"
#include "render/search/filtered_predicates.hpp"

namespace glassbox {

/// A surface that a ray truly meets.
struct TrueHit {
    std::size_t surface = 0;
    Bounded t;             ///< with a running bound; `true_t_of` knows it better
    bool as_near = false;  ///< exactly as near as the nearest, or it is the nearest
};

/// The probe that keeps the surfaces that a ray truly meets.
struct AllMet {
    static constexpr bool only_verdicts = true;

    std::vector<std::size_t> surfaces;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::Met, std::size_t surface, double) { surfaces.push_back(surface); }
};

/// A hit whose t has no bound yet.
inline ProvenHit not_bounded_yet(std::size_t surface) {
    return {surface, {0, std::numeric_limits<double>::infinity()}, 0};
}

/// The true t of a surface that the ray meets, nearly as well as a double can say it: with exact arithmetic, if need
/// be.
template <class Search>
double true_t_of(const Search& search, const Ray<double>& ray, std::size_t surface) {
    return search.predicates().sharpened(ray, not_bounded_yet(surface)).value;
}

/// All that a valid ray truly meets, nearest first; of equals the one listed last. `search` must be a proven one.
template <class Search>
std::vector<TrueHit> true_hits(const Search& search, const Ray<double>& ray) {
    AllMet probe;
    search.trace_proven(ray, probe);
    std::vector<TrueHit> hits;
    for (const std::size_t surface : probe.surfaces)
        hits.push_back({surface, search.predicates().with_bound(ray, not_bounded_yet(surface)).t});
    const auto order = [&](const TrueHit& a, const TrueHit& b) {
        if (surely(a.t < b.t)) return -1;
        if (surely(a.t > b.t)) return 1;
        return compare(*search.predicates().true_t(ray, a.surface), *search.predicates().true_t(ray, b.surface));
    };
    std::ranges::sort(hits, [&](const TrueHit& a, const TrueHit& b) {
        const int which = order(a, b);
        return which != 0 ? which < 0 : a.surface > b.surface;
    });
    for (std::size_t i = 0; i < hits.size() && (i == 0 || order(hits[0], hits[i]) == 0); ++i) hits[i].as_near = true;
    return hits;
}

/// One thing that had to come out otherwise than it truly does, for another surface to be seen.
struct CloseCall {
    std::size_t surface = 0;
    std::optional<std::size_t>
        behind;               ///< it had to be missed, or lie behind this one; none: it had to be met, or missed
    bool is_met = false;      ///< truly
    Decider decider;          ///< what that hangs on
    bool may_differ = false;  ///< rounding may turn it round
    bool has_bounds = true;   ///< and it is known by how much
    std::vector<std::string> undecided_by;  ///< by these formulas
};

/// Whether a program may see a surface first, or none at all.
struct Sight {
    std::vector<CloseCall> calls;  ///< all of them have to come out otherwise
    std::optional<Possible> seen;  ///< the surface's own test

    Cause cause() const;
    /// How many times as far as rounding reaches; of the surest call.
    double times() const;
};

/// What has to come out otherwise for `claimed` to be seen first, or nothing if it is none. `hits` are all that the ray
/// truly meets; `ray` is what may become of it in the other program.
template <class Real>
Sight sight(const Ray<Enclosure<Real>>& ray, const engine::Engine& surfaces, const std::vector<TrueHit>& hits,
            std::optional<std::size_t> claimed, const Formulas& formulas);

/// The surface that a program may see first, of those that `fits(surface, sight)` accepts; else the one that it comes
/// nearest to seeing. None in a scene without surfaces.
template <class Real, class Fits>
std::optional<std::pair<std::size_t, Sight>> easiest(const Ray<Enclosure<Real>>& ray, const engine::Engine& surfaces,
                                                     const std::vector<TrueHit>& hits, const Formulas& formulas,
                                                     const Fits& fits) {
    std::optional<std::pair<std::size_t, Sight>> best;
    const auto rank = [](const Sight& one) { return std::pair(one.cause(), one.times()); };
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        Sight one = sight(ray, surfaces, hits, number, formulas);
        if (!best || rank(one) < rank(best->second)) {
            if (!is_beyond_rounding(one.cause()) && !fits(number, one)) continue;
            best.emplace(number, std::move(one));
        }
    }
    return best;
}

extern template Sight sight(const Ray<Enclosure<float>>&, const engine::Engine&, const std::vector<TrueHit>&,
                            std::optional<std::size_t>, const Formulas&);
extern template Sight sight(const Ray<Enclosure<double>>&, const engine::Engine&, const std::vector<TrueHit>&,
                            std::optional<std::size_t>, const Formulas&);

}  // namespace glassbox
