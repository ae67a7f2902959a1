#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "render/options.hpp"
#include "scene/named.hpp"

namespace glassbox {

// The names of the choices in Options, wherever they are read, written or offered. The names of the shading models are
// in "scene/shading_models.hpp".

inline constexpr NameTable<Scalar, 5> scalars{{
    {"certified", Scalar::certified, "double where error bounds prove it, else exact"},
    {"exact", Scalar::exact, "without any rounding: true, and slow"},
    {"float", Scalar::float_, "24 bits, about 7 digits"},
    {"double", Scalar::double_, "53 bits, about 16 digits"},
    {"long-double", Scalar::long_double, "the longest that the compiler has: 64 bits on x86"},
}};

inline constexpr NameTable<EngineChoice, 3> engines{{
    {"automatic", EngineChoice::automatic, "fast where it answers the same sooner"},
    {"plain", EngineChoice::plain, "all surfaces, one after the other"},
    {"fast", EngineChoice::fast, "those whose boxes the ray meets"},
}};

inline constexpr NameTable<SphereRule, 3> sphere_rules{{
    {"stable", Stable{}, "Haines et al. 2019: compares lengths at the sphere"},
    {"textbook", Textbook{}, "the school's formula: loses small, far spheres"},
    {"levental-2014", Levental2014{}, "the paper's program: a touch misses, only the nearer root"},
}};

inline constexpr NameTable<TriangleRule, 3> triangle_rules{{
    {"pluecker", Pluecker{}, "side products: no two of opposite signs"},
    {"tolerance", Tolerance{}, "the paper's: the signs disagree by less than a number"},
    {"moeller-trumbore", MoellerTrumbore{}, "Cramer's rule; neighbours may leave a gap between them"},
}};

std::string_view name_of(Scalar scalar);
std::string_view name_of(EngineChoice engine);
std::string_view name_of(const SphereRule& rule);
/// The rule's name, without a tolerance's number.
std::string_view name_of(const TriangleRule& rule);

/// The name of the rule's struct in the core: "Stable".
std::string_view struct_of(const SphereRule& rule);
std::string_view struct_of(const TriangleRule& rule);

/// The rule as the command line takes it, with a tolerance's number: "tolerance:10".
std::string written(const TriangleRule& rule);

/// The number's text in "tolerance:10"; nothing for words that do not begin with "tolerance:".
std::optional<std::string_view> tolerance_text(std::string_view written);

}  // namespace glassbox
