#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include <ray.hpp>

#include "numerics/power_of_two_scale.hpp"

namespace glassbox {

/// A ray and a surface, their lengths multiplied by a power of two, and the ray's direction by another one: what was so
/// large or small that products overflow or underflow is of ordinary size, and no digit is lost. Any t of theirs, times
/// `per_t`, is that of those that were given.
template <class Shape>
struct AtOrdinaryScale {
    Ray<double> ray;
    Shape shape;
    double per_t;
};

/// Whether they are so as they are.
template <class Shape>
bool is_of_ordinary_scale(const Ray<double>& ray, const Shape& shape) {
    const auto is_ordinary = [](double size) { return size > 0x1p-60 && size < 0x1p60; };
    return is_ordinary(std::max(greatest_coordinate(ray.P), greatest_coordinate(shape))) &&
           is_ordinary(greatest_coordinate(ray.D));
}

/// Nothing if they are of ordinary size as they are, or cannot be multiplied so.
template <class Shape>
std::optional<AtOrdinaryScale<Shape>> at_ordinary_scale(const Ray<double>& ray, const Shape& shape) {
    if (is_of_ordinary_scale(ray, shape)) return {};
    const double length = std::max(greatest_coordinate(ray.P), greatest_coordinate(shape));
    const double speed = greatest_coordinate(ray.D);
    if (!(length > 0 && speed > 0)) return {};
    const int e = std::ilogb(length), d = std::ilogb(speed);
    if (std::max(std::abs(e), std::abs(d)) > 1000 || std::abs(e - d) > 1000) return {};
    const double by = std::ldexp(1, -e), by_d = std::ldexp(1, -d);
    if (!keeps_digits(ray.P, by) || !keeps_digits(shape, by) || !keeps_digits(ray.D, by_d)) return {};
    return AtOrdinaryScale<Shape>{{by * ray.P, by_d * ray.D}, scaled(shape, by), std::ldexp(1, e - d)};
}

}  // namespace glassbox
