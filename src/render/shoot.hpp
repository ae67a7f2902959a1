#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <ray.hpp>

#include "render/job.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// A ray's result. `surface` and `t` are meaningful only for a hit.
struct Shot {
    enum class Answer { hit, miss, invalid } answer = Answer::invalid;
    std::size_t surface = 0;
    long double t = 0;       ///< in units of |D|, as computed in the chosen scalar
    std::size_t hits = 0;    ///< how many surfaces the ray meets at t > 0
    double t_error = 0;      ///< |t − the true t| is at most this; known only for the scalars certified and exact
    bool by_filter = false;  ///< error bounds decided every test; none needed exact arithmetic
};

/// Traces each ray. A ray that is not finite, or has D = 0, is invalid. Throws Cancelled.
std::vector<Shot> shoot(const Scene& scene, const Options& options, std::span<const Ray<double>> rays,
                        const Job& job = {});

}  // namespace glassbox
