#pragma once
#include <cstdint>
#include <limits>

#include "engine/box_ray.hpp"
#include "engine/engine.hpp"

namespace glassbox::engine {

/// A surface that a ray may meet, where it does at no t below `low`; `sure` says that it does. Here any t is the ray's
/// own: see BoxRay.
struct Candidate {
    std::uint32_t surface;
    bool sure;
    double low;
};

/// The surfaces of which one is what a ray meets first; none where it meets nothing for sure. Where there is one alone,
/// and sure, that is the answer; else the candidates are left for who can tell them apart.
struct Candidates {
    static constexpr int most = 12;

    int count = 0;
    bool is_whole = true;                                   ///< there was a BoxRay, and place enough in the list
    double high = std::numeric_limits<double>::infinity();  ///< the ray surely meets one at a t no larger than this
    Candidate list[most];

    bool is_told() const { return is_whole && (count == 0 || (count == 1 && list[0].sure)); }
};

/// What a ray may meet first of the engine's surfaces, the loose ones left out. Makes it a BoxRay.
Candidates first_candidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes);

/// The same where it matters only whether it meets any: one that is sure stands alone, whether or not it is the first.
Candidates any_candidates(const Engine& engine, const Ray<double>& ray, BoxRay& boxes);

}  // namespace glassbox::engine
