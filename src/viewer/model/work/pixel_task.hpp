#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "explain/explain.hpp"
#include "viewer/model/state/command.hpp"
#include "viewer/model/work/at_rest.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// The story of a pinned pixel; `Told` is where it is put, a member of Results.
template <std::optional<Pixel> ViewerState::*Pinned, auto Told>
struct ExplainPixel {
    struct Request {
        PictureRequest seen;
        Pixel pixel;
        std::filesystem::path file;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const Story>;

    static std::optional<Request> wanted(const ViewerState& state) {
        const std::optional<Pixel> pixel = state.*Pinned;
        if (!pixel || !lies_on(*state.scene, *pixel)) return {};
        return Request{picture_request(state), *pixel, state.file};
    }
    static bool follows_view(const Request& before, const Request& now) {
        return before.seen.scene == now.seen.scene && before.pixel == now.pixel;
    }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        do_at_rest(run, [&] { tell(request, run, deliver); });
    }
    static void tell(const Request& request, const Run& run, const auto& deliver) {
        const PictureRequest& seen = request.seen;
        const Job job = background_job(seen, run);
        const Scene scene = applied(*seen.scene, seen.setup);
        const Options& options = seen.setup.options;
        const auto tell_in = [&](Detail detail) {
            Story story = explain(scene, options, request.pixel.x, request.pixel.y, detail, job);
            story.command = explain_command(words_of(request.file, *seen.scene, seen.setup), request.pixel);
            deliver(std::make_shared<const Story>(std::move(story)));
        };
        // How sure a plain scalar is takes a test of every surface: with so many, that is seen to come later.
        constexpr std::size_t many = 50'000;
        if (!is_proven(options.scalar) && job.engine->size() > many) tell_in(Detail::judged);
        tell_in(Detail::whole);
    }
    static void tidy(const ViewerState& state, Results& results, bool) {
        if (state.*Pinned) return;
        results.*Told = nullptr;
        if constexpr (has_timeline) results.timeline.clear(), results.questions.clear();
    }
    static void show(Result story, Results& results) {
        results.*Told = std::move(story);
        ++results.story_serial;
        if constexpr (!has_timeline) return;
        results.timeline = timeline(*results.story);
        results.questions = questions(*results.story, results.timeline);
    }

private:
    static constexpr bool has_timeline = std::is_same_v<decltype(Told), decltype(&Results::story)>;

    static bool lies_on(const Scene& scene, Pixel pixel) {
        return pixel.x >= 0 && pixel.y >= 0 && pixel.x < scene.width && pixel.y < scene.height;
    }
};

using ExplainPinned = ExplainPixel<&ViewerState::pinned, &Results::story>;
using ExplainCompared = ExplainPixel<&ViewerState::compared, &Results::compared>;

}  // namespace glassbox
