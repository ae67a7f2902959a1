#pragma once
#include <memory>

#include "render/job.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/worker.hpp"

namespace glassbox {

/// What a picture, or an overlay, is computed from.
struct PictureRequest {
    std::shared_ptr<const Scene> scene;
    Setup setup;

    bool operator==(const PictureRequest&) const = default;
};

/// What the state shows.
PictureRequest picture_request(const ViewerState& state);

/// All cores but one: that one is the interface's.
int background_threads();

/// Work on what is seen, with the engine at hand.
Job background_job(const PictureRequest& seen, const Run& run);

}  // namespace glassbox
