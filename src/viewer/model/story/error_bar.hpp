#pragma once
#include <optional>
#include <string>

#include "explain/story.hpp"

namespace glassbox {

/// Where a number and its bound lie on a line with 0 in its middle: positions run from 0, the left end, to 1.
struct ErrorBar {
    enum class Kind {
        exact,      ///< no bound to show
        to_scale,   ///< the bound is drawn on the value's own scale
        magnified,  ///< the bound is too small for that: the line is broken between 0 and the value
        unknown,    ///< nothing is proven, or there is no number
    };
    Kind kind = Kind::unknown;
    double value = .5, low = .5, high = .5;  ///< the bar goes from low to high
    std::optional<double> truth;             ///< where the true value lies; none where it is not known
    bool sign_is_proven = false;             ///< 0 lies outside the bar, or the number is exact
    std::string words;                       ///< "bound < 10⁻¹² of the value"
};

inline constexpr double zero_on_error_bar = .5;

ErrorBar error_bar(const story::Number& number);

/// Returns a power of ten as it is printed: "10⁻¹²".
std::string power_of_ten(int exponent);

}  // namespace glassbox
