#pragma once
#include <cstring>

#include "engine/hierarchy.hpp"

namespace glassbox::engine {

/// Numbers to try vectors with, lane by lane: each array begins where vectors can be loaded from.
struct alignas(64) Operands {
    double A[3][fan_out], B[3][fan_out], x[fan_out], y[fan_out];
    float u[fan_out], v[fan_out], w[fan_out];
    double D[3];
};

/// What is computed of them, by the operations that the inner loops are made of.
struct alignas(64) Results {
    double side[fan_out], quotient[fan_out], root[fan_out];
    float product[fan_out], distance[fan_out], quotient_in_float[fan_out], fused[fan_out];

    /// To the bit.
    friend bool operator==(const Results& a, const Results& b) { return std::memcmp(&a, &b, sizeof a) == 0; }
};
static_assert(sizeof(Results) == fan_out * (3 * sizeof(double) + 4 * sizeof(float)), "no bytes beside the numbers");

}  // namespace glassbox::engine
