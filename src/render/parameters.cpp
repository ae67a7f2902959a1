#include "render/parameters.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace glassbox {

namespace {

constexpr Parameter of_view[] = {
    {"stage",
     Subject::view,
     "1..5",
     "what is used: 1 rays, 2 spheres, 3 triangles, 4 shading, 5 turns (default: 5)",
     1,
     false,
     &Options::stage,
     "",
     {1, 5, "%d"}},
    {"turn", Subject::view, "AXIS:DEGREES,...", "turn the view about the world's axes, in this order: z:10,y:-20", 5,
     true, &Options::turns},
    {"accumulated", Subject::view, "",
     "add the turns one to another, each rounded, instead of turning once by all of them", 5, true,
     &Options::accumulated},
};

// After the coefficients.
constexpr Parameter of_shading[] = {
    {"shading", Subject::shading, "MODEL", "", 4, true, &Shading<double>::model, "Shading model"},
    {"light", Subject::shading, "X,Y,Z", "towards the light, from the world's origin", 4, true, &Setup::light_vector,
     "Light, from the world's origin"},
    {"intensity",
     Subject::shading,
     "I",
     "of the light, 1 for full",
     4,
     true,
     &Setup::light_intensity,
     "intensity I",
     {0, 3, "%.2f"}},
};

constexpr Parameter of_computing[] = {
    {"scalar", Subject::computing, "S", "what the formulas run in", 1, false, &Options::scalar,
     "Scalar: what the formulas run in"},
    {"triangle", Subject::computing, "RULE", "when a triangle is hit", 3, false, &Options::triangle_rule,
     "Triangle rule: when a triangle is hit"},
    {"sphere", Subject::computing, "RULE", "how a sphere's roots are found", 2, false, &Options::sphere_rule,
     "Sphere rule: how its roots are found"},
    {"engine", Subject::computing, "E", "which surfaces a ray is tested against", 1, false, &Options::engine,
     "Engine: which surfaces a ray is tested against"},
};

constexpr Parameter row_of(const Coefficient<double>& row) {
    return {row.name, Subject::shading, row.unit, row.help, 4, true, row.member, row.label, row.usual};
}

template <std::size_t... view, std::size_t... coefficient, std::size_t... shading, std::size_t... computing>
constexpr auto joined(std::index_sequence<view...>, std::index_sequence<coefficient...>,
                      std::index_sequence<shading...>, std::index_sequence<computing...>) {
    return std::array{of_view[view]..., row_of(coefficients<double>[coefficient])..., of_shading[shading]...,
                      of_computing[computing]...};
}

constexpr std::array all =
    joined(std::make_index_sequence<std::size(of_view)>(), std::make_index_sequence<coefficients<double>.size()>(),
           std::make_index_sequence<std::size(of_shading)>(), std::make_index_sequence<std::size(of_computing)>());

// As the value is typed.

std::string typed(bool) { return ""; }
std::string typed(int number) { return fmt::format("{}", number); }
std::string typed(double number) { return fmt::format("{}", number); }
std::string typed(const Vec3<double>& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }
std::string typed(const TriangleRule& rule) { return written(rule); }

std::string typed(const std::vector<Turn<double>>& turns) {
    std::string list;
    for (const auto& [axis, degrees] : turns)
        list += fmt::format("{}{}:{}", list.empty() ? "" : ",", "xyz"[static_cast<int>(axis)], degrees);
    return list;
}

template <class Choice>
std::string typed(const Choice& choice) {
    return std::string(name_of(choice));
}

}  // namespace

std::span<const Parameter> parameters() { return all; }

bool is_same(const Parameter& parameter, const Setup& a, const Setup& b) {
    return std::visit([&](auto member) { return part(a, member) == part(b, member); }, parameter.member);
}

Setup taken_over(Setup setup, const Parameter& parameter, const Setup& from) {
    std::visit([&](auto member) { part(setup, member) = part(from, member); }, parameter.member);
    return setup;
}

std::string written(const Parameter& parameter, const Setup& setup) {
    return with_value(parameter, setup, [](const auto& value) { return typed(value); });
}

}  // namespace glassbox
