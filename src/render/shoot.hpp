#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <ray.hpp>

#include "render/job.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// What became of a ray. `surface` and `t` count for a hit only.
struct Shot {
    enum class Answer { hit, miss, invalid } answer = Answer::invalid;
    std::size_t surface = 0;
    long double t = 0;       ///< in units of |D|, in the scalar that it was computed in
    std::size_t hits = 0;    ///< how many surfaces the ray meets at t > 0
    double t_error = 0;      ///< |t − the true t| is at most this; only the scalars certified and exact know it
    bool by_filter = false;  ///< every verdict was decided by error bounds, none needed exact arithmetic
};

/// Traces each ray. One that is not finite, or has D = 0, is invalid. Throws Cancelled.
std::vector<Shot> shoot(const Scene& scene, const Options& options, std::span<const Ray<double>> rays,
                        const Job& job = {});

}  // namespace glassbox
