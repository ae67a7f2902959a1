#include "render/option_names.hpp"

#include <fmt/format.h>

#include <array>

namespace glassbox {

namespace {

template <class Rule>
using StructNames = std::array<std::string_view, std::variant_size_v<Rule>>;

// In the order of the variants.
constexpr StructNames<SphereRule> sphere_structs{"Stable", "Textbook", "Levental2014"};
constexpr StructNames<TriangleRule> triangle_structs{"Pluecker", "Tolerance", "MoellerTrumbore"};

}  // namespace

std::string_view name_of(Scalar scalar) {
    return name_where(scalars, [&](Scalar one) { return one == scalar; });
}

std::string_view name_of(EngineChoice engine) {
    return name_where(engines, [&](EngineChoice one) { return one == engine; });
}

std::string_view name_of(const SphereRule& rule) {
    return name_where(sphere_rules, [&](const SphereRule& one) { return one.index() == rule.index(); });
}

std::string_view name_of(const TriangleRule& rule) {
    return name_where(triangle_rules, [&](const TriangleRule& one) { return one.index() == rule.index(); });
}

std::string_view struct_of(const SphereRule& rule) { return sphere_structs[rule.index()]; }

std::string_view struct_of(const TriangleRule& rule) { return triangle_structs[rule.index()]; }

std::string written(const TriangleRule& rule) {
    const auto* tolerance = std::get_if<Tolerance>(&rule);
    return std::string(name_of(rule)) + (tolerance ? fmt::format(":{}", tolerance->tolerance) : "");
}

std::optional<std::string_view> tolerance_text(std::string_view written) {
    const std::string_view name = name_of(TriangleRule(Tolerance{}));
    if (!written.starts_with(name) || written.substr(name.size(), 1) != ":") return {};
    return written.substr(name.size() + 1);
}

}  // namespace glassbox
