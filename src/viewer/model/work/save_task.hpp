#pragma once
#include <optional>

#include "render/job.hpp"
#include "scene/error.hpp"
#include "viewer/model/files/save_menu.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// The file that is to be written.
struct SaveFile {
    using Request = Saving;
    using Result = Saved;

    static std::optional<Request> wanted(const ViewerState& state) { return state.saving; }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        Saved saved{request.number, ""};
        try {
            write(request, background_job({request.scene, request.setup}, run));
        } catch (const Error& error) {
            saved.error = error.what();
        }
        deliver(std::move(saved));
    }
    static void show(Result saved, Results& results) { results.saved = std::move(saved); }
};

}  // namespace glassbox
