#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "render/job.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// The nearest hits of all pixels' rays, row by row from the top: the surface's number or engine::no_surface, and t.
struct NearestHits {
    std::vector<std::uint32_t> surface;
    std::vector<float> t;

    explicit NearestHits(const Scene& scene);
};

/// Finds them with the engine, certified: tiles of rays together, or each ray by itself.
void trace_certified(const Scene& scene, const Job& job, NearestHits& hits);
void trace_certified_one_by_one(const Scene& scene, const Job& job, NearestHits& hits);

/// A scene's only mesh in Embree.
class EmbreeScene {
public:
    /// `robust` sets Embree's flag of that name, for rays that would slip between triangles.
    EmbreeScene(const Scene& scene, bool robust);
    ~EmbreeScene();

    double build_seconds() const;
    /// The bytes that Embree allocated for it, without the mesh itself.
    double bytes() const;

    void trace_one_by_one(const Job& job, NearestHits& hits) const;
    void trace_packets(const Job& job, NearestHits& hits) const;  ///< of 4 x 4 pixels

    static std::string version();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace glassbox
