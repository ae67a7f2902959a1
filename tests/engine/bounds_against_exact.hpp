#pragma once
#include <cmath>
#include <vector>

#include <vec3.hpp>

#include "../numerics/doubles.hpp"
#include "engine/engine.hpp"
#include "numerics/exact.hpp"

/// What the tests of bounds share: the core's formulas on numbers without any rounding, and numbers of all magnitudes.
namespace glassbox::test {

inline Vec3<Exact> exact(const Vec3<double>& v) { return convert<Exact>(v); }

inline bool is_less(const Exact& a, const Exact& b) { return compare(a, b) < 0; }

/// A vector about so large, of all directions; now and then along an axis or a plane, or nearly.
inline Vec3<double> some_vector(Doubles& random, double size) {
    double v[3];
    for (double& x : v) {
        x = (2 * random.fraction() - 1) * size;
        if (random.one_in(12)) x = 0;
        if (random.one_in(12)) x *= random.positive(-70, -1);
    }
    return {v[0], v[1], v[2]};
}

/// 10 to a whole power within these.
inline double power_of_ten(Doubles& random, int least, int most) {
    return std::pow(10, least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1))));
}

/// Any magnitude that doubles have, half of the time one that is near 1.
inline double magnitude(Doubles& random) {
    return random.one_in(2) ? power_of_ten(random, -8, 8) : power_of_ten(random, -300, 300);
}

/// An engine of one triangle, whose box reaches so far from `middle` along each axis.
inline engine::Engine engine_of_size(const Vec3<double>& middle, double size) {
    const Vec3<double> corner{size, size, size};
    const std::vector<Triangle<double>> one{{middle - corner, middle + corner, middle}};
    return {{}, one, 1};
}

}  // namespace glassbox::test
