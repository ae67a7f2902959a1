#include "render/measure/measure_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "render/render.hpp"

namespace glassbox {

namespace {

/// A measurement that owns the texts that it points to.
struct Owning {
    std::string name, explanation;
    Measurement measurement;
};

std::shared_ptr<const Measurement> difference_of(const Measurement& what, std::string_view component,
                                                 const Minus& minus, const Setup& setup) {
    const auto owner = std::make_shared<Owning>(Owning{
        difference_name(component, minus),
        fmt::format("{} with {} minus {} with {}; {}: {}", component, told_of(minus, setup), component,
                    told_of(minus, minus.setup), what.name, what.explanation),
        {},
    });
    Measurement& difference = owner->measurement;
    difference.name = owner->name;
    difference.unit = what.unit;
    difference.explanation = owner->explanation;
    difference.scale = Scale::difference;
    difference.source = what.source;
    difference.worst = Worst::farthest_from_0;
    difference.spacing = Spacing::symlog;
    difference.minus_infinity = difference.infinity = "one of the two is infinite";
    return {owner, &difference};
}

Channel subtracted(const Channel& one, const Channel& other, std::string_view name) {
    Channel result{std::string(name), one.width, one.height, {}};
    // ∞ − ∞ would be NaN, and so no value; but nothing differs.
    std::ranges::transform(one.values, other.values, std::back_inserter(result.values),
                           [](double a, double b) { return a == b ? 0.0 : a - b; });
    if (std::ranges::all_of(result.values, [](double value) { return std::isnan(value); }))
        result.why_no_value = !one.why_no_value.empty()     ? one.why_no_value
                              : !other.why_no_value.empty() ? other.why_no_value
                                                            : "no pixel has a value in both";
    return result;
}

}  // namespace

std::vector<MeasuredDifference> measure_difference(const Scene& scene, const Setup& setup, const Minus& minus,
                                                   std::span<const Measurement* const> wanted, const Job& job) {
    const Setup changed = changed_by(minus, setup);
    Job again = job;
    if (changed.options.stage != setup.options.stage) again.engine = nullptr;  // it has that stage's surfaces
    auto ones = measure(applied(scene, setup), setup.options, wanted, job);
    auto others = measure(applied(scene, changed), changed.options, wanted, again);
    std::vector<MeasuredDifference> all;
    for (std::size_t m = 0; m < wanted.size(); ++m)
        for (std::size_t c = 0; c < ones[m].size(); ++c) {
            Channel &one = ones[m][c], &other = others[m][c];
            auto what = difference_of(*wanted[m], one.name, minus, setup);
            Channel channel = subtracted(one, other, what->name);
            all.push_back({std::move(what), std::move(channel), std::move(one), std::move(other)});
        }
    return all;
}

}  // namespace glassbox
