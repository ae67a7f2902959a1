#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <sphere.hpp>
#include <triangle.hpp>

#include "engine/block.hpp"
#include "engine/copies.hpp"
#include "engine/hierarchy.hpp"
#include "numerics/power_of_two_scale.hpp"

// How to use it, as search/fast_search.hpp does in full. Build, once for a scene:
//
//   const Engine engine(spheres, triangles);
//
// Intersect (kernels.hpp): a ray of its own visits the leaves whose boxes it meets, near ones first,
//
//   const std::optional<BoxRay> boxes = box_ray(ray, engine);
//   traverse(engine.hierarchy(), *boxes, t_max, [&](std::uint32_t leaf, float t_max) {
//       … test the leaf's surfaces …
//       return found_one ? boxes->t_max(t) : t_max;
//   });
//
// and surfaces in loose() are tested besides; who wants all that the ray meets asks about copies_of(surface), too.
// Where there is no BoxRay, all surfaces are tested. One loop does all of that for the first hit of a ray:
// ray_kernel.hpp. The rays of neighbouring pixels are traced together: grid, then trace_tile (tile.hpp).

namespace glassbox::engine {

/// A scene's surfaces made ready for rays, once for all views and all rays. Surfaces are numbered as everywhere:
/// spheres first.
class Engine {
public:
    Engine() = default;
    /// 0 threads: as many as the machine has cores.
    Engine(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> triangles, int threads = 0);

    std::size_t size() const { return spheres_.size() + place_.size(); }
    std::size_t sphere_count() const { return spheres_.size(); }
    std::size_t bytes() const;

    /// The power of two by which all is multiplied that the engine holds, so that most of it is of ordinary size: 1 for
    /// most scenes. No digit is lost by it.
    double scale() const { return scale_; }

    // At that scale:

    const std::vector<Sphere<double>>& scaled_spheres() const { return spheres_; }
    Triangle<double> scaled_triangle(std::size_t surface) const {
        const std::uint32_t place = place_[surface - spheres_.size()];
        return blocks_.triangle(place / fan_out, place % fan_out);
    }
    const Hierarchy& hierarchy() const { return hierarchy_; }
    /// One for each leaf of triangles, in their order; then those of loose ones and copies.
    const Blocks& blocks() const { return blocks_; }
    /// The point that the hierarchy's boxes are relative to.
    const Vec3<double>& middle() const { return middle_; }
    /// Around all surfaces of the hierarchy.
    const Box& around() const { return around_; }
    /// How far from the middle they reach along an axis, at most.
    double reach() const { return reach_; }
    /// How far nearly all of them do; what lies beyond must not blur what floats say of the rest.
    float near_reach() const { return near_reach_; }
    /// Surfaces so large that floats cannot hold their boxes: in no leaf, to be tested always.
    const std::vector<std::uint32_t>& loose() const { return loose_; }
    /// The surfaces that are the same as this one and listed before it: in no leaf, for nobody sees them.
    std::span<const Copy> copies_of(std::uint32_t surface) const {
        if (copies_.empty()) return {};
        const auto first = std::lower_bound(copies_.begin(), copies_.end(), Copy{surface, 0});
        auto last = first;
        while (last != copies_.end() && last->of == surface) ++last;
        return {first, last};
    }
    const std::vector<Copy>& copies() const { return copies_; }

    // As the scene has them:

    Triangle<double> triangle(std::size_t surface) const { return as_given(scaled_triangle(surface)); }

    /// Calls `use` with the sphere or the triangle of that number.
    template <class Use>
    auto with_surface(std::size_t surface, const Use& use) const {
        return surface < spheres_.size() ? use(as_given(spheres_[surface])) : use(triangle(surface));
    }

    /// Calls `use(number, surface)` with each of them, in the order in which they are kept.
    template <class Use>
    void for_each_surface(const Use& use) const {
        for (std::size_t i = 0; i < spheres_.size(); ++i) use(i, as_given(spheres_[i]));
        for (std::size_t number = 0; number < blocks_.size(); ++number)
            for (std::uint32_t at = 0; at < blocks_[number].count; ++at)
                use(std::size_t{blocks_[number].surface[at]}, as_given(blocks_.triangle(number, at)));
    }

private:
    template <class Surface>
    Surface as_given(const Surface& surface) const {
        return scale_ == 1 ? surface : scaled(surface, 1 / scale_);
    }

    double scale_ = 1;
    std::vector<Sphere<double>> spheres_;
    std::vector<std::uint32_t> place_;  ///< of each triangle: its block, times 8, and where it stands there
    Blocks blocks_;
    Hierarchy hierarchy_;
    Vec3<double> middle_;
    Box around_;
    double reach_ = 0;
    float near_reach_ = 0;
    std::vector<std::uint32_t> loose_;
    std::vector<Copy> copies_;
};

}  // namespace glassbox::engine
