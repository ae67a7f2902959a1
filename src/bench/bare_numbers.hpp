#pragma once
#include <span>

namespace glassbox {

/// A scene and rays as bare numbers, because the loop is compiled twice, with types that differ for the compiler:
/// spheres of four (centre, radius), triangles of nine (vertices), rays of six (start, direction).
struct BareNumbers {
    std::span<const double> spheres, triangles, rays;
};

/// Traces all rays and adds up t of their nearest hits, with the probe that ignores everything.
double sum_of_t_with_silent_probe(const BareNumbers& numbers);

/// The same loop with a probe that counts tests and hits.
double sum_of_t_with_counting_probe(const BareNumbers& numbers);

/// The same loop, with its probe statements removed from the source before compilation.
double sum_of_t_without_probe(const BareNumbers& numbers);

}  // namespace glassbox
