#include "viewer/model/work/kept_engine.hpp"

#include <algorithm>

#include "render/search/build_engine.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

std::shared_ptr<const engine::Engine> KeptEngine::of(const std::shared_ptr<const Scene>& scene, int stage,
                                                     int threads) {
    const int knows = std::min(stage, stage_of_all_surfaces);
    const std::lock_guard lock(mutex_);
    if (scene_ != scene || stage_ != knows) {
        engine_ = nullptr;  // first, so that two large ones never exist at once
        engine_ = build_engine(*scene, knows, threads);
        scene_ = scene;
        stage_ = knows;
    }
    return engine_;
}

}  // namespace glassbox
