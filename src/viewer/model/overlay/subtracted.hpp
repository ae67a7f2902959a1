#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/model/state/state.hpp"

namespace glassbox {

/// What is subtracted from the measurement that is laid over the picture; null: nothing.
const Minus* subtracted(const Overlay& overlay);

/// Why nothing is subtracted from it, though something was chosen; empty otherwise.
std::string why_not_subtracted(const Overlay& overlay);

/// The name of what is laid over: "depth", "depth-minus-scalar:certified"; empty: nothing is.
std::string name_of(const Overlay& overlay);

/// Subtracts that, or nothing; a range and a brush were for other values.
void subtract(Overlay& overlay, const std::optional<Minus>& minus);

/// What can be subtracted, for a list of them: "scalar:certified".
struct MinusChoice {
    std::string name;
    std::optional<Minus> value;
    std::string_view help;
};

/// Nothing, then all scalars, rules and engines.
std::vector<MinusChoice> minus_choices();

}  // namespace glassbox
