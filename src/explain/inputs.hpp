#pragma once
#include <sphere.hpp>
#include <triangle.hpp>

#include "numerics/recorded.hpp"

namespace glassbox {

// What a tape begins with, under the names that the formulas use.

inline Ray<Recorded> input(Tape& tape, const Ray<double>& ray) {
    return {input(tape, ray.P, "P"), input(tape, ray.D, "D")};
}

inline Sphere<Recorded> input(Tape& tape, const Sphere<double>& sphere) {
    return {input(tape, sphere.c, "centre"), Recorded::input(tape, sphere.r, "radius")};
}

inline Triangle<Recorded> input(Tape& tape, const Triangle<double>& triangle) {
    return {input(tape, triangle.A, "A"), input(tape, triangle.B, "B"), input(tape, triangle.C, "C")};
}

}  // namespace glassbox
