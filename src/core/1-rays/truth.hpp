#pragma once
#include <utility>

namespace glassbox {

/// The result type of comparing two values of the scalar Real: bool for the built-in scalars. A scalar that carries its
/// own error may answer "undecided"; it defines its own type, with `&`, `&&`, `!=`, `surely` and `possibly`.
template <class Real>
using Truth = decltype(std::declval<const Real&>() < std::declval<const Real&>());

/// Whether it is proven true.
constexpr bool surely(bool truth) { return truth; }
/// Whether it could be true.
constexpr bool possibly(bool truth) { return truth; }

/// `condition ? a : b` for a condition that may be undecided: a where it could be true.
template <class Condition, class Value>
constexpr Value choose(const Condition& condition, const Value& a, const Value& b) {
    return possibly(condition) ? a : b;
}

}  // namespace glassbox
