#pragma once
#include <span>
#include <vector>

#include <ray.hpp>
#include <triangle.hpp>

#include "render/measure/triangle_numbers.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Asks exact arithmetic about side products that a scalar computed as 0: whether they are 0, of the numbers as that
/// scalar has them, or only came out so.
class KnownZeros {
public:
    KnownZeros(const Scene& scene, const Options& options);

    /// Whether of each of these triangles, as the scalar sees them from the ray's start, all three signs are what they
    /// were computed as.
    bool are_known(const Ray<double>& ray, std::span<const Triangle<long double>> seen) const;

    /// Lets the numbers of that ray's triangles know of their zeros, if all of them are.
    void take_into(const Ray<double>& ray, TriangleNumbers& numbers) const {
        if (!numbers.zeros.empty() && are_known(ray, numbers.zeros)) numbers.know_zeros();
    }

private:
    std::vector<Triangle<double>> triangles_;
    Scalar scalar_;
};

}  // namespace glassbox
