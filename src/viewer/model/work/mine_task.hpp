#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/model/work/mine.hpp"
#include "viewer/model/work/picture_request.hpp"

namespace glassbox {

/// The picture by the learner's code.
struct DrawMine {
    struct Request {
        PictureRequest seen;
        std::shared_ptr<const learn::Workspace> workspace;
        LessonChoice chosen;
        std::uint64_t saved;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const learn::mine::PictureUpdate>;

    static std::optional<Request> wanted(const ViewerState& state) {
        if (!shows_mine(state) || !state.mine.chosen) return {};
        return Request{picture_request(state), state.mine.workspace, *state.mine.chosen, state.mine.saved};
    }
    static void announce(Tools& tools) { ++tools.mine_asked; }
    static void withdraw(Tools& tools) { tools.mine_made = tools.mine_asked.load(); }
    static void perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver);
    static void tidy(const ViewerState& state, Results& results, bool is_new);
    static void show(Result update, Results& results);
};

/// Lets the learner's picture come first, if one is asked for: two compilers at a time would make both late.
void wait_for_picture(const Run& run);

}  // namespace glassbox
