#pragma once
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/recorded.hpp"

namespace glassbox {

// A tape's inputs, under the names that the formulas use.

template <class Real>
Ray<Recorded<Real>> input(Tape& tape, const Ray<double>& ray) {
    return {input<Real>(tape, ray.P, "P"), input<Real>(tape, ray.D, "D")};
}

template <class Real>
Sphere<Recorded<Real>> input(Tape& tape, const Sphere<double>& sphere) {
    return {input<Real>(tape, sphere.C, "centre"), Recorded<Real>::input(tape, sphere.r, "radius")};
}

template <class Real>
Triangle<Recorded<Real>> input(Tape& tape, const Triangle<double>& triangle) {
    return {input<Real>(tape, triangle.A, "A"), input<Real>(tape, triangle.B, "B"), input<Real>(tape, triangle.C, "C")};
}

}  // namespace glassbox
