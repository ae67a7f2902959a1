#pragma once
#include <utility>

namespace glassbox {

/// What comparing two values of the scalar Real answers: a bool for the built-in ones. A scalar that carries its own
/// error may answer "undecided"; it brings a truth of its own, with `&`, `&&`, `!=`, `surely` and `possibly`.
template <class Real>
using Truth = decltype(std::declval<const Real&>() < std::declval<const Real&>());

/// Is it proven true?
constexpr bool surely(bool truth) { return truth; }
/// Could it be true?
constexpr bool possibly(bool truth) { return truth; }

}  // namespace glassbox
