#pragma once
#include <optional>
#include <span>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "compare/compare_rays.hpp"

namespace glassbox {

// Phrases and JSON of what rays and pictures have in common.

/// "side product b = -0.25 ± 1.8e-15", however it is rounded.
std::string decider_text(const Decider& decider);

/// "surface 7 is truly missed, and rounding does not change it: side product b = -0.25 ± 1.8e-15, 1.3e+14 times …".
std::string call_text(const CloseCall& call);

/// The calls to tell: of a mistake those that no rounding turns round, the surest first; else all. A few of them.
std::vector<CloseCall> telling_calls(std::vector<CloseCall> calls, Cause cause);

/// "rounding may do this".
std::string_view cause_text(Cause cause);

/// A number of times, with two digits: "640"; "1.3e+14".
std::string times_text(double times);

/// "rounding in float, by the formulas stable, textbook, pluecker and moeller-trumbore".
std::string theirs_text(const Theirs& theirs);

/// How many differences rounding does not explain, as far as is known.
template <class Comparison>
std::size_t count_beyond_rounding(const Comparison& comparison) {
    return comparison.count(Cause::mistake) + comparison.count(Cause::unknown);
}

/// "in float rounding may do 12 of these 15 …"; empty where it would explain less than half of them, or was not asked.
std::string float_text(std::size_t beyond_double, std::optional<std::size_t> beyond_float);

nlohmann::ordered_json calls_json(std::span<const CloseCall> calls);
nlohmann::ordered_json theirs_json(const Theirs& theirs);

}  // namespace glassbox
