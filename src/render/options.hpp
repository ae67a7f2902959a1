#pragma once
#include <vector>

#include <turn.hpp>

#include "render/rules.hpp"

namespace glassbox {

/// The scalar in which the formulas are evaluated.
enum class Scalar { certified, float_, double_, long_double, exact };

/// Whether the scalar proves its answers: hit or miss is mathematically correct, and t has a bound on its error.
constexpr bool is_proven(Scalar scalar) { return scalar == Scalar::certified || scalar == Scalar::exact; }

/// Which surfaces a ray is tested against.
enum class EngineChoice {
    automatic,  ///< fast where it gives the same answers sooner
    plain,      ///< all surfaces, one after the other
    fast,       ///< those that a hierarchy of boxes leaves; for proven answers by rules that are geometry
};

/// How a scene is traced.
struct Options {
    int stage = 5;                    ///< 1: rays, 2: + spheres, 3: + triangles, 4: + shading, 5: + turns
    std::vector<Turn<double>> turns;  ///< of the view, about the scene's pivot, in this order
    /// Accumulates the turns, each rounded, like a program that rotates its points at every key press; otherwise
    /// rebuilds the view from all turns at once.
    bool accumulated = false;
    Scalar scalar = Scalar::certified;
    EngineChoice engine = EngineChoice::automatic;
    SphereRule sphere_rule;
    TriangleRule triangle_rule;

    bool operator==(const Options&) const = default;
};

}  // namespace glassbox
