#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/kept_engine.hpp"
#include "viewer/model/work/latest.hpp"
#include "viewer/model/work/pace.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// Computes what a state shows, in the background, and only what has changed. Uses all cores but one: that one is the
/// interface's.
class Background {
public:
    /// `wake` is called from other threads whenever there is something new.
    explicit Background(const std::function<void()>& wake);

    /// Starts what is missing for this state, stops what is not needed any more, and puts into `results` what is ready.
    void update(const ViewerState& state, Results& results);

private:
    /// What a picture, or an overlay, is computed from.
    struct Seen {
        std::shared_ptr<const Scene> scene;
        Setup setup;

        bool operator==(const Seen&) const = default;
    };
    struct SeenPixel {
        Seen seen;
        Pixel pixel;
        std::filesystem::path file;

        bool operator==(const SeenPixel&) const = default;
    };
    struct SeenMeasured {
        Seen seen;
        const Measurement* what;

        bool operator==(const SeenMeasured&) const = default;
    };
    /// What a hierarchy is made from.
    struct Sorted {
        std::shared_ptr<const Scene> scene;
        int stage;

        bool operator==(const Sorted&) const = default;
    };
    struct SeenMine {
        Seen seen;
        std::shared_ptr<const learn::Workspace> workspace;
        int lesson;
        std::uint64_t saved;

        bool operator==(const SeenMine&) const = default;
    };
    /// A worker, and what it was last asked for.
    template <class What, class Result>
    struct Worker {
        explicit Worker(const std::function<void()>& wake) : latest(wake) {}
        std::optional<What> asked;
        std::shared_ptr<Pace> pace = std::make_shared<Pace>();
        Latest<Result> latest;
    };
    using StoryWorker = Worker<SeenPixel, std::shared_ptr<const Story>>;

    /// Work on what is seen, with the engine at hand.
    static Job background_job(KeptEngine& engine, const Seen& seen, const std::stop_token& stop);

    void ask_for_picture(Worker<Seen, Picture>& worker, const std::optional<Seen>& seen, bool counted);
    void ask_for_mine(const std::optional<SeenMine>& wanted);
    void update_mine(const ViewerState& state, const Seen& seen, Results& results);
    void ask_for_overlay(const std::optional<SeenMeasured>& wanted);
    void ask_for_boxes(const std::optional<Sorted>& wanted, Results& results);
    void ask_for_story(StoryWorker& worker, const std::optional<SeenPixel>& wanted);

    std::shared_ptr<std::atomic<std::int64_t>> pixels_done_;
    std::shared_ptr<KeptEngine> engine_;
    Worker<Seen, Picture> picture_, other_;
    std::shared_ptr<learn::mine::Maker> maker_;
    Worker<SeenMine, std::shared_ptr<const learn::mine::News>> mine_;
    Worker<SeenMeasured, std::shared_ptr<const MeasuredPlanes>> overlay_;
    StoryWorker story_, compared_;
    Worker<Sorted, std::shared_ptr<const BoxLevels>> boxes_;
};

}  // namespace glassbox
