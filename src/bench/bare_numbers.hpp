#pragma once
#include <span>

namespace glassbox {

/// A scene and rays as bare numbers, as the loop is compiled twice, with types that are not the same to the compiler:
/// spheres of four (centre, radius), triangles of nine (vertices), rays of six (start, direction).
struct BareNumbers {
    std::span<const double> spheres, triangles, rays;
};

/// Traces all rays and adds up t of what they meet first, with the probe that listens to nothing.
double sum_of_t_with_silent_probe(const BareNumbers& numbers);

/// The same loop with a probe that counts tests and hits.
double sum_of_t_with_counting_probe(const BareNumbers& numbers);

/// The same loop, its probe statements taken out of the source before it was compiled.
double sum_of_t_without_probe(const BareNumbers& numbers);

}  // namespace glassbox
