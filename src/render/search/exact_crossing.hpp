#pragma once
#include <array>
#include <memory>
#include <optional>

#include <bounded.hpp>
#include <ray.hpp>

#include "render/rules.hpp"

namespace glassbox {

class Exact;

/// A hit's exact t. It hides numerics/exact.hpp, which takes compilers seconds to read: only code that computes with
/// the number includes that.
class TrueT {
public:
    explicit TrueT(Exact t);

    const Exact& exact() const { return *t_; }
    Bounded to_bounded() const;
    /// -1, 0 or 1 as a is less than, equal to or greater than b.
    friend int compare(const TrueT& a, const TrueT& b);

private:
    std::shared_ptr<const Exact> t_;
};

// The true t at which a valid ray meets a surface, if it does: the core's formula evaluated without any rounding.
std::optional<TrueT> exact_crossing(const Ray<double>& ray, const Sphere<double>& sphere, const SphereRule& rule);
std::optional<TrueT> exact_crossing(const Ray<double>& ray, const Triangle<double>& triangle, const TriangleRule& rule);

/// The signs of a triangle's side products, -1, 0 or 1, without any rounding. All numbers must be finite.
std::array<int, 3> exact_side_signs(const Ray<double>& ray, const Triangle<double>& triangle);

// The unit normal there, each coordinate of it, before it gets length 1, rounded once. None for a ray that does not
// meet the surface, or a triangle without area.
std::optional<Vec3<double>> exact_normal(const Ray<double>& ray, const Sphere<double>& sphere, const SphereRule& rule);
std::optional<Vec3<double>> exact_normal(const Ray<double>& ray, const Triangle<double>& triangle,
                                         const TriangleRule& rule);

}  // namespace glassbox
