#include "viewer/model/work/background.hpp"

#include "viewer/model/work/boxes_task.hpp"
#include "viewer/model/work/mine_task.hpp"
#include "viewer/model/work/picture_tasks.hpp"
#include "viewer/model/work/pixel_task.hpp"
#include "viewer/model/work/save_task.hpp"
#include "viewer/model/work/steps_task.hpp"
#include "viewer/model/work/surfaces_task.hpp"
#include "viewer/model/work/tests_task.hpp"
#include "viewer/model/work/thumbnail_task.hpp"
#include "viewer/model/work/worker.hpp"

namespace glassbox {

/// All that is done in the background; more is one more task here.
struct Background::Work {
    explicit Work(const std::function<void()>& wake) : workers(wake) {}

    Workers<RenderPicture, RenderOther, DrawMine, StepMine, TestMine, MeasureOverlay, ExplainPinned, ExplainCompared,
            CountBoxes, FindSurfaces, SaveFile, DrawThumbnails>
        workers;
};

Background::Background(const std::function<void()>& wake) : work_(std::make_unique<Work>(wake)) {}

Background::~Background() = default;

void Background::update(const ViewerState& state, Results& results) {
    work_->workers.update(state, results);
    const double pixels = 1.0 * state.scene->width * state.scene->height;
    const bool rendering = work_->workers.busy<RenderPicture>();
    results.progress = rendering ? static_cast<double>(work_->workers.tools().pixels_done) / pixels : 1;
}

}  // namespace glassbox
