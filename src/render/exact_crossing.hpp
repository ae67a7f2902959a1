#pragma once
#include <optional>

#include <levental_2014.hpp>
#include <ray.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/exact.hpp"

namespace glassbox {

// The true t at which a valid ray meets a surface, if it does: the core's formula run without any rounding. Compiled
// once, for what it takes the compiler.
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Textbook& roots);
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Stable& roots);
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const Levental2014& roots);
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle, const Pluecker& test);
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle, const Tolerance& test);
std::optional<Exact> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle,
                                    const MoellerTrumbore& test);

}  // namespace glassbox
