#pragma once
#include <memory>
#include <mutex>

#include "engine/engine.hpp"
#include "scene/scene.hpp"

namespace glassbox {

/// The engine of the scene that is shown: made when it is first needed, once for all threads.
class KeptEngine {
public:
    /// Returns the engine of the surfaces that the stage knows.
    std::shared_ptr<const engine::Engine> of(const std::shared_ptr<const Scene>& scene, int stage, int threads);

private:
    std::mutex mutex_;
    std::shared_ptr<const Scene> scene_;
    int stage_ = 0;
    std::shared_ptr<const engine::Engine> engine_;
};

}  // namespace glassbox
