#include "compare/sight.hpp"

namespace glassbox {

namespace {

CloseCall call_of(std::size_t surface, bool is_met, const Possible& test) {
    return {.surface = surface,
            .behind = {},
            .is_met = is_met,
            .decider = test.decider,
            .may_differ = is_met ? test.may_be_missed() : test.may_be_met(),
            .has_bounds = test.has_bounds,
            .undecided_by = test.undecided_by};
}

/// What had to come out otherwise for `seen` to be seen before `nearer`: that one is missed, or their order is another.
/// What is easier counts.
CloseCall overtaking(std::size_t nearer, const Possible& its_test, std::size_t seen, const Possible& test) {
    CloseCall call = call_of(nearer, true, its_test);
    call.behind = seen;
    const auto middle = [](const Possible& p) { return p.least_t / 2 + p.most_t / 2; };
    const Decider order{"the difference of the two t", middle(test) - middle(its_test),
                        Bounded::up(test.most_t / 2 - test.least_t / 2 + (its_test.most_t / 2 - its_test.least_t / 2))};
    const bool may_swap = !(its_test.most_t < test.least_t);
    if (may_swap && !call.may_differ) {
        call.decider = order;
        call.may_differ = true;
        call.undecided_by.clear();
    } else if (!call.may_differ && order.times() > 0 && order.times() < call.decider.times()) {
        call.decider = order;
    }
    return call;
}

}  // namespace

Cause Sight::cause() const {
    const bool may_be = std::ranges::all_of(calls, &CloseCall::may_differ);
    if (!may_be) return Cause::mistake;
    return std::ranges::all_of(calls, &CloseCall::has_bounds) ? Cause::rounding : Cause::unknown;
}

double Sight::times() const {
    double most = 0;
    for (const CloseCall& call : calls) most = std::max(most, call.decider.times());
    return most;
}

template <class Real>
Sight sight(const Ray<Enclosure<Real>>& ray, const engine::Engine& surfaces, const std::vector<TrueHit>& hits,
            std::optional<std::size_t> claimed, const Formulas& formulas) {
    const auto test = [&](std::size_t surface, bool is_met) {
        return possible(ray, surfaces, surface, is_met, formulas);
    };
    Sight result;
    if (!claimed) {
        for (const TrueHit& hit : hits) result.calls.push_back(call_of(hit.surface, true, test(hit.surface, true)));
        return result;
    }
    const auto truly = std::ranges::find(hits, *claimed, &TrueHit::surface);
    const bool is_met = truly != hits.end();
    result.seen = test(*claimed, is_met);
    if (!is_met) {
        result.calls.push_back(call_of(*claimed, false, *result.seen));
        if (!result.seen->may_be_met()) return result;
    }
    for (auto nearer = hits.begin(); nearer != truly; ++nearer)
        if (!(is_met && truly->as_near))
            result.calls.push_back(overtaking(nearer->surface, test(nearer->surface, true), *claimed, *result.seen));
    return result;
}

template Sight sight(const Ray<Enclosure<float>>&, const engine::Engine&, const std::vector<TrueHit>&,
                     std::optional<std::size_t>, const Formulas&);
template Sight sight(const Ray<Enclosure<double>>&, const engine::Engine&, const std::vector<TrueHit>&,
                     std::optional<std::size_t>, const Formulas&);

}  // namespace glassbox
