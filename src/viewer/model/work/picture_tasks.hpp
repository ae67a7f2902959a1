#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/render.hpp"
#include "viewer/model/work/mine.hpp"
#include "viewer/model/work/picture_request.hpp"
#include "viewer/model/work/progressive.hpp"

namespace glassbox {

/// The picture.
struct RenderPicture {
    using Request = PictureRequest;
    using Result = Picture;

    static std::optional<Request> wanted(const ViewerState& state) { return picture_request(state); }
    static bool goes_on(const Request& before, const Request& now) { return before.scene == now.scene; }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        run.tools.pixels_done = 0;
        render_finer(request, run, &run.tools.pixels_done, deliver);
    }
    static void show(Result picture, Results& results) {
        results.picture = std::move(picture);
        ++results.picture_serial;
    }

    /// Counts the pixels of the last size, if anyone watches.
    static void render_finer(const Request& request, const Run& run, std::atomic<std::int64_t>* done,
                             const auto& deliver) {
        const auto picture = [&](const Scene& scene, int factor, Job job) {
            job.done = factor == 1 ? done : nullptr;
            return Picture{std::make_shared<const Image>(render(scene, request.setup.options, job)), factor};
        };
        coarse_to_fine(applied(*request.scene, request.setup), background_job(request, run), run.pace, picture,
                       deliver);
    }
};

/// The same by another scalar and other rules.
struct RenderOther {
    using Request = PictureRequest;
    using Result = Picture;

    static bool is_shown(const ViewerState& state) {
        return state.beside == Beside::other || state.beside == Beside::difference;
    }
    static std::optional<Request> wanted(const ViewerState& state) {
        if (!is_shown(state)) return {};
        PictureRequest other = picture_request(state);
        other.setup.options.scalar = state.other.scalar;
        other.setup.options.sphere_rule = state.other.sphere_rule;
        other.setup.options.triangle_rule = state.other.triangle_rule;
        return other;
    }
    static bool goes_on(const Request& before, const Request& now) { return before.scene == now.scene; }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        RenderPicture::render_finer(request, run, nullptr, deliver);
    }
    static void tidy(const ViewerState& state, Results& results, bool) {
        if (!is_shown(state) && !shows_mine(state)) results.other = {};
    }
    static void show(Result picture, Results& results) {
        results.other = std::move(picture);
        ++results.other_serial;
    }
};

/// What the chosen measurement says of each pixel.
struct MeasureOverlay {
    struct Request {
        PictureRequest seen;
        const Measurement* what;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const MeasuredChannels>;

    static std::optional<Request> wanted(const ViewerState& state) {
        const Measurement* const what = find_measurement(state.overlay.measurement);
        return what ? std::optional(Request{picture_request(state), what}) : std::nullopt;
    }
    static bool goes_on(const Request& before, const Request& now) {
        return before.seen.scene == now.seen.scene && before.what == now.what;
    }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        const auto& [seen, what] = request;
        const auto measured = [&](const Scene& scene, int factor, const Job& job) {
            std::vector<Channel> channels =
                measure(scene, request.seen.setup.options, std::span(&request.what, 1), job).front();
            FoundPixels found = factor == 1 ? find_pixels(*request.what, channels.front()) : FoundPixels{};
            return std::make_shared<const MeasuredChannels>(MeasuredChannels{
                request.what, std::move(channels), factor, request.seen.scene, request.seen.setup, std::move(found)});
        };
        coarse_to_fine(applied(*seen.scene, seen.setup), background_job(seen, run), run.pace, measured, deliver);
    }
    static void tidy(const ViewerState& state, Results& results, bool) {
        if (!find_measurement(state.overlay.measurement)) results.overlay = nullptr;
    }
    static void show(Result overlay, Results& results) {
        results.overlay = std::move(overlay);
        ++results.overlay_serial;
    }
};

}  // namespace glassbox
