#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/model/work/mine.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// The steps of the pinned pixel by the learner's code.
struct StepMine {
    struct Request {
        PictureRequest seen;
        Pixel pixel;
        std::shared_ptr<const learn::Workspace> workspace;
        LessonChoice chosen;
        std::uint64_t saved;

        bool operator==(const Request&) const = default;
    };
    using Result = MineSteps;

    static std::optional<Request> wanted(const ViewerState& state);
    static void perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver);
    static void tidy(const ViewerState& state, Results& results, bool is_new);
    static void show(Result steps, Results& results);
};

}  // namespace glassbox
