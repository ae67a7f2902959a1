#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/trace_certified.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Whether rays that follow each other are near each other and run the same way: Embree wants to be told.
enum class Coherence { none, high };

/// A scene's only mesh in Embree.
class EmbreeScene {
public:
    /// `robust` sets Embree's flag of that name, for rays that would slip between triangles.
    EmbreeScene(const Scene& scene, bool robust);
    ~EmbreeScene();

    double build_seconds() const;
    /// The bytes that Embree allocated for it, without the mesh itself.
    double bytes() const;

    void trace(std::span<const Ray<float>> rays, Coherence coherence, const Job& job, NearestHits& hits) const;
    /// 16 at a time. There must be a multiple of these.
    void trace_packets(std::span<const Ray<float>> rays, const Job& job, NearestHits& hits) const;
    void occluded(std::span<const Ray<float>> rays, Coherence coherence, const Job& job,
                  std::vector<std::uint8_t>& answers) const;

    static std::string version();

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace glassbox
