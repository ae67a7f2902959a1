#pragma once
#include <array>

namespace glassbox::test {

/// The ray that a test traced last, and the surface that it was traced against: when a check fails, `glassbox learn`
/// makes a scene of them that the viewer can open.
struct TracedRay {
    std::array<double, 6> ray{};      ///< P and D
    std::array<double, 9> surface{};  ///< a sphere's centre and radius, or a triangle's vertices
    int numbers = 0;                  ///< how many of those: 4, 9, or 0 when nothing was traced
};

/// A global, since a failing test has no other way to hand it to the reporter.
inline TracedRay& last_traced_ray() {
    static TracedRay last;
    return last;
}

template <class Ray, class Surface>
void trace(const Ray& ray, const Surface& surface) {
    TracedRay& last = last_traced_ray();
    const auto put = [](auto& array, int at, const auto& vector) {
        for (const auto number : {vector.x, vector.y, vector.z})
            array[static_cast<std::size_t>(at++)] = static_cast<double>(number);
        return at;
    };
    put(last.ray, put(last.ray, 0, ray.P), ray.D);
    if constexpr (requires { surface.r; }) {
        last.numbers = put(last.surface, 0, surface.C) + 1;
        last.surface[3] = static_cast<double>(surface.r);
    } else {
        last.numbers = put(last.surface, put(last.surface, put(last.surface, 0, surface.A), surface.B), surface.C);
    }
}

}  // namespace glassbox::test
