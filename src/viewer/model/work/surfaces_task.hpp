#pragma once
#include <memory>
#include <optional>
#include <span>

#include "render/render.hpp"
#include "viewer/model/overlay/surfaces_in_picture.hpp"
#include "viewer/model/work/at_rest.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// Which surface each pixel shows, as long as one is lit up.
struct FindSurfaces {
    using Request = PictureRequest;
    using Result = std::shared_ptr<const SurfacesInPicture>;

    static std::optional<Request> wanted(const ViewerState& state) {
        const bool one_is_lit = state.pointed_surface || (state.page == Page::steps && state.pinned);
        return one_is_lit ? std::optional(picture_request(state)) : std::nullopt;
    }
    static bool follows_view(const Request& before, const Request& now) { return before.scene == now.scene; }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        Result& last = run.tools.surfaces;
        if (!last || last->scene != request.scene || last->setup != request.setup)
            do_at_rest(run, [&] { last = found(request, run); });
        deliver(last);
    }
    static Result found(const Request& request, const Run& run) {
        const Measurement* const what = &surface_met();
        std::vector<Channel> channels = measure(applied(*request.scene, request.setup), request.setup.options,
                                                std::span(&what, 1), background_job(request, run))
                                            .front();
        return std::make_shared<const SurfacesInPicture>(
            SurfacesInPicture{std::move(channels.front()), request.scene, request.setup});
    }
    static void show(Result surfaces, Results& results) {
        results.surfaces = std::move(surfaces);
        ++results.surfaces_serial;
    }
};

}  // namespace glassbox
