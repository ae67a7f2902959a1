#pragma once
#include <type_traits>

#include "render/options.hpp"

namespace glassbox {

/// The scalar of a story's steps: the one that computes the picture. For `certified` and `exact` that is double, from t
/// on: exact arithmetic decides what the ray meets, and where.
constexpr Scalar scalar_of_steps(Scalar scalar) { return is_proven(scalar) ? Scalar::double_ : scalar; }

/// Calls `use` with that scalar's std::type_identity.
template <class Use>
auto with_scalar_of_steps(Scalar scalar, const Use& use) {
    switch (scalar_of_steps(scalar)) {
        case Scalar::float_:
            return use(std::type_identity<float>{});
        case Scalar::long_double:
            return use(std::type_identity<long double>{});
        default:
            return use(std::type_identity<double>{});
    }
}

}  // namespace glassbox
