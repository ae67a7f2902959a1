#pragma once
#include <type_traits>

#include "compare/cause.hpp"

namespace glassbox {

/// Calls `use` with the precision's std::type_identity.
template <class Use>
auto with_precision(TheirPrecision precision, const Use& use) {
    if (precision == TheirPrecision::float_) return use(std::type_identity<float>{});
    return use(std::type_identity<double>{});
}

}  // namespace glassbox
