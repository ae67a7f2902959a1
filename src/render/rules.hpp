#pragma once
#include <variant>

#include <intersect_sphere.hpp>
#include <levental_2014.hpp>
#include <moeller_trumbore.hpp>
#include <tolerance.hpp>

namespace glassbox {

using SphereRule = std::variant<Stable, Textbook, Levental2014>;
using TriangleRule = std::variant<Pluecker, Tolerance, MoellerTrumbore>;

/// Whether a rule is geometry: without rounding, it meets a surface exactly where the surface is. The other rules are
/// the paper's program's, kept as history.
constexpr bool is_geometry(const SphereRule& rule) { return !std::holds_alternative<Levental2014>(rule); }
constexpr bool is_geometry(const TriangleRule& rule) { return !std::holds_alternative<Tolerance>(rule); }

/// A rule chosen at run time and called like any other, so that loops are compiled once, not for each rule.
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
