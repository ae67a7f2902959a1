#include "render/search/build_engine.hpp"

#include "render/search/surfaces.hpp"

namespace glassbox {

namespace {

/// Up to this many surfaces, the plain loop takes at most some microseconds per ray.
constexpr std::size_t small = 2000;

}  // namespace

std::shared_ptr<const engine::Engine> build_engine(const Scene& scene, int stage, int threads) {
    Surfaces<double> all = surfaces<double>(scene, stage);
    return std::make_shared<engine::Engine>(std::move(all.spheres), all.triangles, threads);
}

bool uses_engine(const Scene& scene, const Options& options, bool for_pictures) {
    if (options.engine == EngineChoice::plain || !engine_can(options)) return false;
    if (options.engine == EngineChoice::fast || for_pictures) return true;
    const auto [spheres, triangles] = count_surfaces(scene, options.stage);
    return spheres + triangles > small;
}

}  // namespace glassbox
