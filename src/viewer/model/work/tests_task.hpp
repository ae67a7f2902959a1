#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "viewer/model/state/state.hpp"
#include "viewer/model/work/results.hpp"
#include "viewer/model/work/worker.hpp"

namespace glassbox {

/// The lesson's tests of the learner's code, after each save.
struct TestMine {
    struct Request {
        std::shared_ptr<const learn::Workspace> workspace;
        int lesson;
        std::uint64_t saved;

        bool operator==(const Request&) const = default;
    };
    using Result = std::shared_ptr<const learn::ToldTests>;

    static std::optional<Request> wanted(const ViewerState& state) {
        if (!runs_tests(state)) return {};
        return Request{state.mine.workspace, exercise_of(state.mine)->number, state.mine.saved};
    }
    static void perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver);
    static void tidy(const ViewerState& state, Results& results, bool is_new);
    /// While tests run, what the last ones said stays.
    static void show(Result tests, Results& results);
};

}  // namespace glassbox
