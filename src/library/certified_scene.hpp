#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <ray.hpp>
#include <sphere.hpp>
#include <triangle.hpp>

namespace glassbox {

namespace engine {
class Engine;
}

/// Where a ray meets a surface: the true t, in units of |D|, lies within t ± t_error. Both are infinite if t is larger
/// than any double; the order of hits is right all the same.
struct CertifiedHit {
    std::size_t surface;
    double t, t_error;
};

/// Spheres and triangles that answer rays with the mathematics' own word: which surfaces a ray meets, which it meets
/// first, in which order. Coordinates are taken as they are, and nothing is ever missed or met by rounding. Surfaces
/// are closed sets: edges, vertices and tangent rays count. A ray meets what lies ahead of its start, t > 0.
///
/// Surfaces are numbered spheres first, then triangles, each in their order. Copies share what was built. Any number of
/// threads may ask at once.
class CertifiedScene {
public:
    /// Builds the hierarchy of boxes, on as many threads as asked for; 0: on all. Throws std::invalid_argument for a
    /// number that is not finite and a radius that is not above 0, and names the surface.
    CertifiedScene(std::vector<Sphere<double>> spheres, std::span<const Triangle<double>> triangles, int threads = 0);

    std::size_t size() const;

    /// What the ray meets first; of surfaces at the same distance the one listed last. Throws std::invalid_argument for
    /// a ray whose numbers are not finite or whose direction is 0.
    std::optional<CertifiedHit> first_hit(const Ray<double>& ray) const;

    /// All surfaces that the ray meets, each once, in the order in which it meets them first; of surfaces at the same
    /// distance the one listed last comes first. Throws as first_hit does.
    std::vector<CertifiedHit> all_hits(const Ray<double>& ray) const;

private:
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
