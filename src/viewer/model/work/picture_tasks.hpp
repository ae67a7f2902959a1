#pragma once
#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/measure/measure_difference.hpp"
#include "render/render.hpp"
#include "viewer/model/overlay/subtracted.hpp"
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
        std::optional<Minus> minus;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const MeasuredChannels>;

    static std::optional<Request> wanted(const ViewerState& state) {
        const Measurement* const what = find_measurement(state.overlay.measurement);
        if (!what) return {};
        const Minus* const minus = subtracted(state.overlay);
        return Request{picture_request(state), what, minus ? std::optional(*minus) : std::nullopt};
    }
    static bool goes_on(const Request& before, const Request& now) {
        return before.seen.scene == now.seen.scene && before.what == now.what && before.minus == now.minus;
    }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        const PictureRequest& seen = request.seen;
        const auto made = [&](const Scene& scene, int factor, const Job& job) {
            MeasuredChannels result = request.minus ? difference(request, scene, job) : measured(request, scene, job);
            result.factor = factor;
            result.scene = request.seen.scene;
            result.setup = request.seen.setup;
            if (factor == 1) result.found = find_pixels(*result.what, result.channels.front());
            return std::make_shared<const MeasuredChannels>(std::move(result));
        };
        coarse_to_fine(applied(*seen.scene, seen.setup), background_job(seen, run), run.pace, made, deliver);
    }
    static MeasuredChannels measured(const Request& request, const Scene& scene, const Job& job) {
        MeasuredChannels result;
        result.what = request.what;
        result.channels = measure(scene, request.seen.setup.options, std::span(&request.what, 1), job).front();
        return result;
    }
    static MeasuredChannels difference(const Request& request, const Scene& scene, const Job& job) {
        std::vector<MeasuredDifference> differences =
            measure_difference(scene, request.seen.setup, *request.minus, std::span(&request.what, 1), job);
        MeasuredDifference& only = differences.front();
        MeasuredChannels result;
        result.difference = std::move(only.what);
        result.what = result.difference.get();
        result.channels.push_back(std::move(only.channel));
        result.both.push_back(std::move(only.one));
        result.both.push_back(std::move(only.other));
        return result;
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
