#include "viewer/model/work/background.hpp"

#include <algorithm>
#include <thread>

#include "explain/explain.hpp"
#include "render/render.hpp"
#include "render/search/surfaces.hpp"
#include "viewer/model/space/boxes_in_space.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/work/progressive.hpp"

namespace glassbox {

namespace {

int background_threads() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

bool lies_on(const Scene& scene, Pixel pixel) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < scene.width && pixel.y < scene.height;
}

}  // namespace

Background::Background(const std::function<void()>& wake)
    : pixels_done_(std::make_shared<std::atomic<std::int64_t>>(0)),
      engine_(std::make_shared<KeptEngine>()),
      picture_(wake),
      other_(wake),
      maker_(std::make_shared<learn::mine::Maker>()),
      mine_(wake),
      overlay_(wake),
      story_(wake),
      compared_(wake),
      boxes_(wake) {}

Job Background::background_job(KeptEngine& engine, const PictureRequest& seen, const std::stop_token& stop) {
    Job job{.threads = background_threads(), .stop = stop};
    job.engine = engine.of(seen.scene, seen.setup.options.stage, job.threads);
    return job;
}

void Background::ask_for_picture(Worker<PictureRequest, Picture>& worker, const std::optional<PictureRequest>& seen,
                                 bool counted) {
    if (worker.asked == seen) return;
    const bool goes_on = worker.asked && seen && worker.asked->scene == seen->scene;
    worker.asked = seen;
    if (!seen) return worker.latest.cancel();
    auto work = [seen = *seen, engine = engine_, pace = worker.pace, done = counted ? pixels_done_ : nullptr](
                    const std::stop_token& stop, const auto& deliver) {
        if (done) *done = 0;
        const auto picture = [&](const Scene& scene, int factor, Job job) {
            job.done = factor == 1 ? done.get() : nullptr;
            return Picture{std::make_shared<const Image>(render(scene, seen.setup.options, job)), factor};
        };
        coarse_to_fine(applied(*seen.scene, seen.setup), background_job(*engine, seen, stop), *pace, picture, deliver);
    };
    worker.latest.ask(std::move(work), goes_on);
}

void Background::ask_for_mine(const std::optional<MineRequest>& wanted) {
    if (mine_.asked == wanted) return;
    mine_.asked = wanted;
    if (!wanted) return mine_.latest.cancel();
    mine_.latest.ask([wanted = *wanted, maker = maker_](const std::stop_token& stop, const auto& deliver) {
        const auto tell = [&](learn::mine::PictureUpdate update) {
            deliver(std::make_shared<const learn::mine::PictureUpdate>(std::move(update)));
        };
        const learn::Exercise& exercise = learn::exercise_called(*wanted.workspace, std::to_string(wanted.lesson));
        try {
            maker->make(*wanted.workspace, exercise, applied(*wanted.seen.scene, wanted.seen.setup),
                        wanted.seen.setup.options, tell, stop);
        } catch (const std::exception& error) {  // the machine cannot do it
            learn::mine::PictureUpdate update;
            update.stand = learn::mine::Stand::not_there;
            update.words = error.what();
            tell(std::move(update));
        }
    });
}

void Background::update_mine(const ViewerState& state, const PictureRequest& seen, Results& results) {
    const bool shown = shows_mine(state);
    if (!shown && results.mine) results.mine = nullptr, results.other = {};
    const bool possible = shown && exercise_of(state.mine);
    ask_for_mine(possible ? std::optional(MineRequest{seen, state.mine.workspace, state.mine.lesson, state.mine.saved})
                          : std::nullopt);
    if (!shown) return;
    const auto& last = results.other.image;
    if (!results.mine || (last && (last->width != seen.scene->width || last->height != seen.scene->height)))
        results.other = {};
    if (!results.mine) results.mine = std::make_shared<const learn::mine::PictureUpdate>();
}

void Background::ask_for_overlay(const std::optional<MeasurementRequest>& wanted) {
    if (overlay_.asked == wanted) return;
    const bool goes_on = overlay_.asked && wanted && overlay_.asked->seen.scene == wanted->seen.scene &&
                         overlay_.asked->what == wanted->what;
    overlay_.asked = wanted;
    if (!wanted) return overlay_.latest.cancel();
    auto work = [wanted = *wanted, engine = engine_, pace = overlay_.pace](const std::stop_token& stop,
                                                                           const auto& deliver) {
        const PictureRequest& seen = wanted.seen;
        const auto measured = [&](const Scene& scene, int factor, const Job& job) {
            std::vector<Channel> channels =
                measure(scene, wanted.seen.setup.options, std::span(&wanted.what, 1), job).front();
            return std::make_shared<const MeasuredPlanes>(MeasuredPlanes{wanted.what, std::move(channels), factor});
        };
        coarse_to_fine(applied(*seen.scene, seen.setup), background_job(*engine, seen, stop), *pace, measured, deliver);
    };
    overlay_.latest.ask(std::move(work), goes_on);
}

void Background::ask_for_boxes(const std::optional<BoxesRequest>& wanted, Results& results) {
    if (boxes_.asked == wanted) return;
    boxes_.asked = wanted;
    results.boxes = nullptr;  // those of other surfaces
    if (!wanted) return boxes_.latest.cancel();
    boxes_.latest.ask([wanted = *wanted, engine = engine_](const std::stop_token&, const auto& deliver) {
        const auto& [scene, stage] = wanted;
        deliver(std::make_shared<const BoxLevels>(box_levels(engine->of(scene, stage, background_threads()))));
    });
}

void Background::ask_for_story(StoryWorker& worker, const std::optional<PixelRequest>& wanted) {
    if (worker.asked == wanted) return;
    worker.asked = wanted;
    if (!wanted) return worker.latest.cancel();
    worker.latest.ask([wanted = *wanted, engine = engine_](const std::stop_token& stop, const auto& deliver) {
        const auto& [seen, pixel, file] = wanted;
        Story story = explain(applied(*seen.scene, seen.setup), seen.setup.options, pixel.x, pixel.y, Detail::whole,
                              background_job(*engine, seen, stop));
        story.command = explain_command(file, *seen.scene, seen.setup, pixel);
        deliver(std::make_shared<const Story>(std::move(story)));
    });
}

void Background::update(const ViewerState& state, Results& results) {
    const PictureRequest seen{state.scene, state.setup.now()};
    ask_for_picture(picture_, seen, true);

    const bool with_other = state.beside == Beside::other || state.beside == Beside::difference;
    PictureRequest other = seen;
    other.setup.options.scalar = state.other.scalar;
    other.setup.options.sphere_rule = state.other.sphere_rule;
    other.setup.options.triangle_rule = state.other.triangle_rule;
    ask_for_picture(other_, with_other ? std::optional(other) : std::nullopt, false);
    if (!with_other && !shows_mine(state)) results.other = {};
    update_mine(state, seen, results);

    const Measurement* const what = find_measurement(state.overlay.measurement);
    ask_for_overlay(what ? std::optional(MeasurementRequest{seen, what}) : std::nullopt);
    if (!what) results.overlay = nullptr;

    const auto at = [&](const std::optional<Pixel>& pixel) {
        return pixel && lies_on(*state.scene, *pixel) ? std::optional(PixelRequest{seen, *pixel, state.file})
                                                      : std::nullopt;
    };
    ask_for_story(story_, at(state.pinned));
    ask_for_story(compared_, at(state.compared));
    if (!state.pinned) {
        results.story = nullptr;
        results.timeline.clear();
    }
    if (!state.compared) results.compared = nullptr;

    const bool with_boxes = state.box_level && state.space_shown;
    const int sorted_stage = std::min(seen.setup.options.stage, stage_of_all_surfaces);
    ask_for_boxes(with_boxes ? std::optional(BoxesRequest{state.scene, sorted_stage}) : std::nullopt, results);

    const auto take = [](auto& worker, auto& into, std::uint64_t& serial) {
        auto result = worker.latest.take();
        if (!result) return false;
        into = std::move(*result);
        ++serial;
        return true;
    };
    // Read before anything is taken: what ends in between counts as still busy, and is there at the next update.
    results.busy = picture_.latest.busy() || other_.latest.busy() || mine_.latest.busy() || overlay_.latest.busy() ||
                   story_.latest.busy() || compared_.latest.busy() || boxes_.latest.busy();
    take(picture_, results.picture, results.picture_serial);
    take(other_, results.other, results.other_serial);
    if (take(mine_, results.mine, results.mine_serial) && results.mine->drawing) {
        const bool whole = results.mine->stand == learn::mine::Stand::drawn;
        const auto& drawing = results.mine->drawing;
        results.other = {std::shared_ptr<const Image>(drawing, &drawing->image), whole ? 1 : 2};
        ++results.other_serial;
    }
    take(overlay_, results.overlay, results.overlay_serial);
    if (take(story_, results.story, results.story_serial)) results.timeline = timeline(*results.story);
    take(compared_, results.compared, results.story_serial);
    if (auto made = boxes_.latest.take()) results.boxes = std::move(*made);

    const double pixels = 1.0 * state.scene->width * state.scene->height;
    results.progress = picture_.latest.busy() ? static_cast<double>(*pixels_done_) / pixels : 1;
    results.error.clear();
    for (const std::string& error :
         {picture_.latest.error(), other_.latest.error(), mine_.latest.error(), overlay_.latest.error(),
          story_.latest.error(), compared_.latest.error(), boxes_.latest.error()})
        if (!error.empty()) results.error = error;
}

}  // namespace glassbox
