#include "viewer/model/work/picture_request.hpp"

#include <algorithm>
#include <thread>

namespace glassbox {

PictureRequest picture_request(const ViewerState& state) { return {state.scene, state.setup.now()}; }

int background_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

Job background_job(const PictureRequest& seen, const Run& run) {
    Job job{.threads = background_threads(), .stop = run.stop};
    job.engine = run.tools.engine.of(seen.scene, seen.setup.options.stage, job.threads);
    return job;
}

}  // namespace glassbox
