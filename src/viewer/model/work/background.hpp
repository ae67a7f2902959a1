#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "learn/picture/maker.hpp"
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
    struct PictureRequest {
        std::shared_ptr<const Scene> scene;
        Setup setup;

        bool operator==(const PictureRequest&) const = default;
    };
    struct PixelRequest {
        PictureRequest seen;
        Pixel pixel;
        std::filesystem::path file;

        bool operator==(const PixelRequest&) const = default;
    };
    struct MeasurementRequest {
        PictureRequest seen;
        const Measurement* what;

        bool operator==(const MeasurementRequest&) const = default;
    };
    /// What a hierarchy is made from.
    struct BoxesRequest {
        std::shared_ptr<const Scene> scene;
        int stage;

        bool operator==(const BoxesRequest&) const = default;
    };
    struct MineRequest {
        PictureRequest seen;
        std::shared_ptr<const learn::Workspace> workspace;
        int lesson;
        std::uint64_t saved;

        bool operator==(const MineRequest&) const = default;
    };
    /// A worker, and what it was last asked for.
    template <class What, class Result>
    struct Worker {
        explicit Worker(const std::function<void()>& wake) : latest(wake) {}
        std::optional<What> asked;
        std::shared_ptr<Pace> pace = std::make_shared<Pace>();
        Latest<Result> latest;
    };
    using StoryWorker = Worker<PixelRequest, std::shared_ptr<const Story>>;

    /// Work on what is seen, with the engine at hand.
    static Job background_job(KeptEngine& engine, const PictureRequest& seen, const std::stop_token& stop);

    void ask_for_picture(Worker<PictureRequest, Picture>& worker, const std::optional<PictureRequest>& seen,
                         bool counted);
    void ask_for_mine(const std::optional<MineRequest>& wanted);
    void update_mine(const ViewerState& state, const PictureRequest& seen, Results& results);
    void ask_for_overlay(const std::optional<MeasurementRequest>& wanted);
    void ask_for_boxes(const std::optional<BoxesRequest>& wanted, Results& results);
    void ask_for_story(StoryWorker& worker, const std::optional<PixelRequest>& wanted);

    std::shared_ptr<std::atomic<std::int64_t>> pixels_done_;
    std::shared_ptr<KeptEngine> engine_;
    Worker<PictureRequest, Picture> picture_, other_;
    std::shared_ptr<learn::mine::Maker> maker_;
    Worker<MineRequest, std::shared_ptr<const learn::mine::PictureUpdate>> mine_;
    Worker<MeasurementRequest, std::shared_ptr<const MeasuredPlanes>> overlay_;
    StoryWorker story_, compared_;
    Worker<BoxesRequest, std::shared_ptr<const BoxLevels>> boxes_;
};

}  // namespace glassbox
