#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// Builds the engine with the surfaces of a scene that a stage knows. One engine serves every view of the scene.
std::shared_ptr<const engine::Engine> build_engine(const Scene& scene, int stage, int threads = 0);

/// Whether the engine can answer as the options ask: it proves its answers, and finds surfaces by where they lie. Rules
/// that are history hit triangles where they are not, and miss spheres where they are.
inline bool engine_can(const Options& options) {
    return options.scalar == Scalar::certified && is_geometry(options.sphere_rule) &&
           is_geometry(options.triangle_rule);
}

/// Whether the engine is used. If a probe listens to the tests, or all hits are wanted, small scenes use the plain
/// loop: the probe then hears the lessons' own tests.
bool uses_engine(const Scene& scene, const Options& options, bool for_pictures);

}  // namespace glassbox
