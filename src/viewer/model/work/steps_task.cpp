#include "viewer/model/work/steps_task.hpp"

#include <exception>
#include <string>
#include <utility>

#include "explain/explain.hpp"
#include "explain/retold.hpp"
#include "viewer/model/work/mine_task.hpp"

namespace glassbox {

namespace {

/// The surfaces whose tests our story of the pixel lists: theirs are worth seeing, too.
std::vector<std::size_t> listed_by_ours(const Scene& scene, const Options& options, Pixel pixel, const Job& job) {
    std::vector<std::size_t> listed;
    for (const story::Surface& surface : explain(scene, options, pixel.x, pixel.y, Detail::judged, job).surfaces)
        listed.push_back(surface.number);
    return listed;
}

}  // namespace

std::optional<StepMine::Request> StepMine::wanted(const ViewerState& state) {
    const MineChoice& mine = state.mine;
    if (!mine.is_stepped || !mine.chosen || !state.pinned) return {};
    const auto [x, y] = *state.pinned;
    if (x < 0 || y < 0 || x >= state.scene->width || y >= state.scene->height) return {};
    return Request{picture_request(state), *state.pinned, mine.workspace, *mine.chosen, mine.saved};
}

void StepMine::perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver) {
    const auto& [seen, pixel, workspace, chosen, saved] = request;
    const Scene scene = applied(*seen.scene, seen.setup);
    const Options& options = seen.setup.options;
    const Job job = background_job(seen, run);
    const Pixel at = pixel;
    const auto tell = [&](learn::mine::RecordingUpdate update) {
        MineSteps steps;
        if (update.pixel) {
            steps.story = std::make_shared<const Story>(retold(scene, job.engine, options, at.x, at.y, *update.pixel));
            steps.timeline = timeline(*steps.story);
        }
        steps.update = std::move(update);
        deliver(std::move(steps));
    };
    wait_for_picture(run);
    try {
        const learn::mine::ToRecord what{scene, options, at, listed_by_ours(scene, options, at, job)};
        learn::mine::Maker& maker = run.tools.recorder;
        if (const int* const lesson = std::get_if<int>(&chosen))
            maker.record(*workspace, {&learn::exercise_called(*workspace, std::to_string(*lesson))}, what, tell,
                         run.stop);
        else maker.record_with_all(*workspace, what, tell, run.stop);
    } catch (const std::exception& error) {  // the machine cannot do it
        learn::mine::RecordingUpdate update;
        update.stand = learn::mine::Stand::not_there;
        update.words = error.what();
        tell(std::move(update));
    }
}

void StepMine::tidy(const ViewerState& state, Results& results, bool is_new) {
    // Other code, or another pixel: what is shown belongs to neither.
    if (is_new || !wanted(state)) {
        const std::uint64_t serial = results.mine_steps.story_serial;
        results.mine_steps = {};
        results.mine_steps.story_serial = serial;
    }
}

void StepMine::show(Result steps, Results& results) {
    const std::uint64_t serial = results.mine_steps.story_serial;
    results.mine_steps = std::move(steps);
    results.mine_steps.story_serial = serial + 1;
}

}  // namespace glassbox
