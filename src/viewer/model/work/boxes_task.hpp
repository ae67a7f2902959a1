#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "render/search/surfaces.hpp"
#include "viewer/model/space/boxes_in_space.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// The boxes of the engine's hierarchy.
struct CountBoxes {
    /// What a hierarchy is made from.
    struct Request {
        std::shared_ptr<const Scene> scene;
        int stage;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const BoxLevels>;

    static std::optional<Request> wanted(const ViewerState& state) {
        if (!state.box_level || !state.space_shown) return {};
        return Request{state.scene, std::min(state.setup.now().options.stage, stage_of_all_surfaces)};
    }
    static void perform(const Request& request, const Run& run, const auto& deliver) {
        const auto& [scene, stage] = request;
        deliver(std::make_shared<const BoxLevels>(box_levels(run.tools.engine.of(scene, stage, background_threads()))));
    }
    static void tidy(const ViewerState&, Results& results, bool is_new) {
        if (is_new) results.boxes = nullptr;  // those of other surfaces
    }
    static void show(Result boxes, Results& results) { results.boxes = std::move(boxes); }
};

}  // namespace glassbox
