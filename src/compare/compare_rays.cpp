#include "compare/compare_rays.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "compare/precision.hpp"
#include "render/parallel.hpp"
#include "render/search/with_search.hpp"

namespace glassbox {

namespace {

/// Judges one ray after the other, by what may become of it in the precision Real.
template <class Real, class Search>
class RayJudge {
public:
    RayJudge(const Search& search, const engine::Engine& surfaces, const Formulas& formulas, const Claims& claims)
        : search_(search), surfaces_(surfaces), formulas_(formulas), claims_(claims) {}

    RayDifference judge(std::size_t number, const Ray<double>& ray, const Shot& truth) const {
        const Claim& claim = claims_.rays[number];
        RayDifference result;
        result.ray = number;
        if (claim.answer == Shot::Answer::invalid || truth.answer == Shot::Answer::invalid)
            judge_validity(result, ray, claim, truth);
        else if (claim.answer == Shot::Answer::miss) judge_miss(result, ray, truth);
        else judge_hit(result, ray, claim, truth);
        return result;
    }

private:
    using TheirRay = Ray<Enclosure<Real>>;

    /// A ray of ordinary numbers may be none in another scalar: a direction that underflows, an origin too far away.
    static void judge_validity(RayDifference& result, const Ray<double>& ray, const Claim& claim, const Shot& truth) {
        if (claim.answer == truth.answer) return;
        result.wrong = Wrong::validity;
        const bool is_lost = truth.answer != Shot::Answer::invalid && !is_valid(convert<Real>(ray));
        result.cause = is_lost ? Cause::rounding : Cause::mistake;
    }

    void judge_miss(RayDifference& result, const Ray<double>& ray, const Shot& truth) const {
        if (truth.answer == Shot::Answer::miss) return;
        result.wrong = Wrong::miss;
        take(result, sight(theirs(ray), surfaces_, true_hits(search_, ray), {}, formulas_));
    }

    void judge_hit(RayDifference& result, const Ray<double>& ray, const Claim& claim, const Shot& truth) const {
        const bool is_right = truth.answer == Shot::Answer::hit && (!claim.surface || *claim.surface == truth.surface);
        if (is_right && (!claim.t || is_same_t(*claim.t, truth.t))) return;
        if (!claim.surface && !(is_right && may_have(ray, truth.surface, claim)))
            return judge_unnamed(result, ray, claim, truth);
        const std::size_t named = claim.surface.value_or(truth.surface);
        if (is_right) return judge_t(result, claim, truth.t, possible(theirs(ray), surfaces_, named, true, formulas_));

        result.wrong = truth.answer == Shot::Answer::hit ? Wrong::surface : Wrong::hit;
        const std::vector<TrueHit> hits = true_hits(search_, ray);
        const Sight seen = sight(theirs(ray), surfaces_, hits, named, formulas_);
        take(result, seen);
        const auto met = std::ranges::find(hits, named, &TrueHit::surface);
        if (met != hits.end() && met->as_near) result.cause = Cause::tie;
        if (!claim.t || is_beyond_rounding(result.cause)) return;
        const bool is_met = met != hits.end();
        const auto its_true_t = is_met ? std::optional(true_t_of(search_, ray, named)) : std::nullopt;
        if (is_met && is_same_t(*claim.t, *its_true_t)) return;
        RayDifference its_t = result;
        judge_t(its_t, claim, its_true_t, *seen.seen);
        // What explains the surface need not explain its t.
        if (its_t.cause > result.cause) result = its_t;
    }

    /// A hit of a surface that is not told, and not the true one by its t.
    void judge_unnamed(RayDifference& result, const Ray<double>& ray, const Claim& claim, const Shot& truth) const {
        const std::vector<TrueHit> hits = true_hits(search_, ray);
        const auto fits = [&](std::size_t, const Sight& one) {
            return !claim.t || one.seen->may_have(*claim.t, claims_.half_digit_if_shortened(*claim.t, digits));
        };
        result.wrong = truth.answer == Shot::Answer::hit ? Wrong::t : Wrong::hit;
        if (const auto best = easiest(theirs(ray), surfaces_, hits, formulas_, fits)) take(result, best->second);
        else result.cause = Cause::mistake;
        if (!hits.empty() && claim.t && result.wrong == Wrong::t && is_beyond_rounding(result.cause))
            judge_t(result, claim, static_cast<double>(truth.t),
                    possible(theirs(ray), surfaces_, truth.surface, true, formulas_));
    }

    /// Judges the t of a surface that they name; `truth`, its own, is none where it is not met.
    void judge_t(RayDifference& result, const Claim& claim, std::optional<double> truth, const Possible& test) const {
        const double give_or_take = claims_.half_digit_if_shortened(*claim.t, digits);
        result.wrong = Wrong::t;
        if (truth) result.t_off = *claim.t - *truth;
        result.t_bound = Bounded::up(test.most_t / 2 - test.least_t / 2 + give_or_take);
        if (test.may_have(*claim.t, give_or_take)) {
            result.cause = test.has_bounds ? Cause::rounding : Cause::unknown;
            return;
        }
        result.cause = Cause::mistake;
        result.calls.clear();
        const double times = truth && result.t_bound > 0 ? std::abs(*result.t_off) / result.t_bound : 0;
        result.times = std::isnan(times) ? std::numeric_limits<double>::infinity() : times;
    }

    bool may_have(const Ray<double>& ray, std::size_t surface, const Claim& claim) const {
        return possible(theirs(ray), surfaces_, surface, true, formulas_)
            .may_have(*claim.t, claims_.half_digit_if_shortened(*claim.t, digits));
    }

    /// The same in their scalar, and as far as they have written it.
    bool is_same_t(double t, long double truth) const {
        const auto true_t = static_cast<double>(truth);
        return static_cast<Real>(t) == static_cast<Real>(true_t) ||
               std::abs(t - true_t) <= claims_.half_digit_if_shortened(t, digits);
    }

    static TheirRay theirs(const Ray<double>& ray) { return convert<Enclosure<Real>>(ray); }

    static void take(RayDifference& result, const Sight& seen) {
        result.cause = seen.cause();
        result.times = seen.times();
        result.calls = seen.calls;
    }

    static constexpr int digits = digits_of<Real>;

    const Search& search_;
    const engine::Engine& surfaces_;
    const Formulas& formulas_;
    const Claims& claims_;
};

}  // namespace

std::size_t RayComparison::count(Cause cause) const {
    return static_cast<std::size_t>(std::ranges::count(differences, cause, &RayDifference::cause));
}

std::size_t RayComparison::count(Wrong wrong, Cause cause) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        differences, [&](const RayDifference& one) { return one.wrong == wrong && one.cause == cause; }));
}

RayComparison compare_rays(const Scene& scene, const Options& options, std::span<const Ray<double>> rays,
                           const Claims& claims, const Theirs& theirs, const Job& job, std::vector<Shot> truth) {
    Options proven = options;
    if (engine_can(proven)) proven.engine = EngineChoice::fast;
    Job ours = job;
    if (!ours.engine) ours.engine = build_engine(scene, options.stage, job.threads);
    if (truth.size() != rays.size()) truth = shoot(scene, proven, rays, ours);
    RayComparison result{std::move(truth), {}};

    std::mutex adding;
    with_search<AllMet>(scene, proven, reach_of(rays), ours, [&]<class Search>(const Search& search) {
        if constexpr (requires { search.predicates(); })
            with_precision(theirs.precision, [&]<class Real>(std::type_identity<Real>) {
                const RayJudge<Real, Search> judge(search, *ours.engine, theirs.formulas, claims);
                for_each_index(rays.size(), ours, [&](std::size_t i) {
                    RayDifference one = judge.judge(i, rays[i], result.ours[i]);
                    if (one.cause == Cause::same) return;
                    const std::lock_guard lock(adding);
                    result.differences.push_back(std::move(one));
                });
            });
    });
    std::ranges::sort(result.differences, {}, &RayDifference::ray);
    return result;
}

}  // namespace glassbox
