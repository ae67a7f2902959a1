#include "render/option_names.hpp"

#include <fmt/format.h>

namespace glassbox {

std::string_view name_of(Scalar scalar) {
    return name_where(scalars, [&](Scalar one) { return one == scalar; });
}

std::string_view name_of(Engine engine) {
    return name_where(engines, [&](Engine one) { return one == engine; });
}

std::string_view name_of(const SphereRule& rule) {
    return name_where(sphere_rules, [&](const SphereRule& one) { return one.index() == rule.index(); });
}

std::string_view name_of(const TriangleRule& rule) {
    return name_where(triangle_rules, [&](const TriangleRule& one) { return one.index() == rule.index(); });
}

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
