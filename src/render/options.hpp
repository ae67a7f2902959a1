#pragma once
#include <vector>

#include <turn.hpp>

#include "render/rules.hpp"

namespace glassbox {

/// The scalar that the formulas run in.
enum class Scalar { certified, float_, double_, long_double, exact };

/// Whether it answers with a proof: the verdict is the mathematics' own, and t comes with a bound on its error.
constexpr bool is_proven(Scalar scalar) { return scalar == Scalar::certified || scalar == Scalar::exact; }

/// Which surfaces a ray is tested against.
enum class EngineChoice {
    automatic,  ///< fast where it answers the same sooner
    plain,      ///< all, one after the other
    fast,       ///< those that a hierarchy of boxes leaves over; for proven answers by the rules that are geometry
};

/// How a scene is traced.
struct Options {
    int stage = 5;                    ///< 1 rays, 2 + spheres, 3 + triangles, 4 + shading, 5 + turns
    std::vector<Turn<double>> turns;  ///< of the view, about the scene's pivot, in this order
    /// The turns are added one to another, each rounded, as a program does that rotates its points at every key;
    /// otherwise the view is rebuilt from all of them at once.
    bool accumulated = false;
    Scalar scalar = Scalar::certified;
    EngineChoice engine = EngineChoice::automatic;
    SphereRule sphere_rule;
    TriangleRule triangle_rule;

    bool operator==(const Options&) const = default;
};

}  // namespace glassbox
