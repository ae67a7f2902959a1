#include "compare/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "numerics/printed_bound.hpp"
#include "render/option_names.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

std::vector<std::string> names_of(const Formulas& formulas) {
    std::vector<std::string> all;
    for (const SphereRule& rule : formulas.spheres) all.emplace_back(name_of(rule));
    for (const TriangleRule& rule : formulas.triangles) all.push_back(written(rule));
    return all;
}

std::string_view name_of_precision(TheirPrecision precision) {
    return name_where(precisions, [&](TheirPrecision one) { return one == precision; });
}

/// What truly holds: "surface 7 is missed".
std::string truth_of(const CloseCall& call) {
    if (call.behind) return fmt::format("surface {} lies before surface {}", call.surface, *call.behind);
    return fmt::format("surface {} is {}", call.surface, call.is_met ? "met" : "missed");
}

std::string by_formulas(const CloseCall& call) {
    return call.undecided_by.empty() ? std::string() : ", by " + either(call.undecided_by);
}

}  // namespace

std::string decider_text(const Decider& decider) {
    if (!std::isfinite(decider.value)) return fmt::format("{} overflows", decider.what);
    if (!std::isfinite(decider.error)) return fmt::format("{} has no bound", decider.what);
    const std::string value = value_beside(decider.value, decider.error);
    if (decider.error == 0) return fmt::format("{} = {} exactly, whatever is rounded", decider.what, value);
    return fmt::format("{} = {} ± {}", decider.what, value, bound_beside(value, decider.value, decider.error));
}

std::string times_text(double times) {
    return times < 1000 ? fmt::format("{:.2g}", times) : fmt::format("{:.1e}", times);
}

std::string call_text(const CloseCall& call) {
    const std::string number = call.decider.what.empty() ? std::string() : ": " + decider_text(call.decider);
    const double times = call.decider.times();
    if (!call.may_differ && times > 1 && std::isfinite(times))
        return fmt::format("{}{}, {} times as far from 0 as rounding reaches", truth_of(call), number,
                           times_text(times));
    if (!call.may_differ) return truth_of(call) + number;
    if (!call.has_bounds) return fmt::format("{}, but numbers grow too large, or too small, to tell", truth_of(call));
    // The number is the first formula's; another one may be less sure.
    const bool by_number = !number.empty() && call.decider.error > 0 && !(times > 1);
    return fmt::format("{}, which rounding may turn round{}{}", truth_of(call), by_formulas(call),
                       by_number ? number : "");
}

std::vector<CloseCall> telling_calls(std::vector<CloseCall> calls, Cause cause) {
    constexpr std::size_t most = 3;
    if (cause == Cause::mistake) std::erase_if(calls, [](const CloseCall& call) { return call.may_differ; });
    std::ranges::stable_sort(calls, std::greater{}, [](const CloseCall& call) { return call.decider.times(); });
    calls.resize(std::min(calls.size(), most));
    return calls;
}

std::string_view cause_text(Cause cause) {
    for (const auto& [name, value, help] : causes)
        if (value == cause) return help;
    return "";
}

std::string theirs_text(const Theirs& theirs) {
    return fmt::format("rounding in {}, by the formulas {}", name_of_precision(theirs.precision),
                       enumerated(names_of(theirs.formulas)));
}

std::string float_text(std::size_t beyond_double, std::optional<std::size_t> beyond_float) {
    if (!beyond_float || *beyond_float >= (beyond_double + 1) / 2) return "";
    return fmt::format(
        "in float rounding may do {} of these {}: if that is what they compute in, write --precision float",
        beyond_double - *beyond_float, beyond_double);
}

nlohmann::ordered_json calls_json(std::span<const CloseCall> calls) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const CloseCall& call : calls)
        all.push_back({{"surface", call.surface},
                       {"before", call.behind ? nlohmann::ordered_json(*call.behind) : nlohmann::ordered_json(nullptr)},
                       {"truly_met", call.is_met},
                       {"may_differ", call.may_differ},
                       {"has_bounds", call.has_bounds},
                       {"formulas", call.undecided_by},
                       {"what", call.decider.what},
                       {"value", call.decider.value},
                       {"error", call.decider.error},
                       {"times", call.decider.times()}});
    return all;
}

nlohmann::ordered_json theirs_json(const Theirs& theirs) {
    return {{"precision", name_of_precision(theirs.precision)}, {"formulas", names_of(theirs.formulas)}};
}

}  // namespace glassbox
