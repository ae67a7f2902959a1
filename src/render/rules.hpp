#pragma once
#include <type_traits>
#include <utility>
#include <variant>

#include <levental_2014.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

namespace glassbox {

using SphereRule = std::variant<Stable, Textbook, Levental2014>;
using TriangleRule = std::variant<Pluecker, Tolerance, MoellerTrumbore>;

/// Whether a rule is geometry: without rounding it meets a surface where that is, and nowhere else. What the paper's
/// program has instead is history.
constexpr bool is_geometry(const SphereRule& rule) { return !std::holds_alternative<Levental2014>(rule); }
constexpr bool is_geometry(const TriangleRule& rule) { return !std::holds_alternative<Tolerance>(rule); }

/// A rule that is chosen at run time, and asked as any other. Loops are then compiled once, and not for each rule.
template <class Rule>
struct Chosen {
    Rule rule;

    template <class Real, class Surface, class Probe>
    constexpr auto operator()(const Ray<Real>& ray, const Surface& surface, Probe& probe) const {
        return std::visit([&](const auto& chosen) { return chosen(ray, surface, probe); }, rule);
    }
};

template <class Rule>
Chosen(const Rule&) -> Chosen<Rule>;

}  // namespace glassbox
