#pragma once
#include <memory>

#include "engine/engine.hpp"
#include "render/options.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// A scene's surfaces in the engine, as far as a stage knows them: made once, they serve every view of the scene.
std::shared_ptr<const engine::Engine> build_engine(const Scene& scene, int stage, int threads = 0);

/// Whether the engine answers as the options ask: it proves its answers, and knows surfaces by where they lie. Rules
/// that are history hit triangles where they are not, and miss spheres where they are.
inline bool engine_can(const Options& options) {
    return options.scalar == Scalar::certified && is_geometry(options.sphere_rule) &&
           is_geometry(options.triangle_rule);
}

/// Whether it is used. Where tests are listened to, or all hits are wanted, small scenes are left to the plain loop:
/// what is heard of is then the lessons' own.
bool uses_engine(const Scene& scene, const Options& options, bool for_pictures);

}  // namespace glassbox
