#pragma once
#include <cstddef>
#include <string_view>

#include "scene/named.hpp"

namespace glassbox {

/// What explains that two programs differ, from the least alarming on.
enum class Cause {
    same,      ///< they do not differ
    tie,       ///< they name different surfaces at exactly the same t: both are right
    rounding,  ///< a sign or a number that decides lies within what rounding may move it
    unknown,   ///< a bound that would tell is infinite: numbers too large or too small for the precision
    mistake,   ///< no rounding of the formulas in question explains it
};
inline constexpr std::size_t cause_count = 5;

inline constexpr NameTable<Cause, cause_count> causes{{
    {"same", Cause::same, ""},
    {"tie", Cause::tie, "another surface at exactly the same t"},
    {"rounding", Cause::rounding, "rounding may do this"},
    {"unknown", Cause::unknown, "not known: the bound that would tell is infinite"},
    {"mistake", Cause::mistake, "rounding cannot do this"},
}};

/// The precision that another program computes in.
enum class TheirPrecision { float_, double_ };

inline constexpr NameTable<TheirPrecision, 2> precisions{{
    {"double", TheirPrecision::double_, "53 bits, about 16 digits"},
    {"float", TheirPrecision::float_, "24 bits, about 7 digits"},
}};

/// Whether there is anything that rounding may not have done, as far as is known.
constexpr bool is_beyond_rounding(Cause cause) { return cause >= Cause::unknown; }

}  // namespace glassbox
