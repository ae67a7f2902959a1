#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <tuple>
#include <utility>

#include "learn/picture/maker.hpp"
#include "viewer/model/state/state.hpp"
#include "viewer/model/work/kept_engine.hpp"
#include "viewer/model/work/latest.hpp"
#include "viewer/model/work/pace.hpp"
#include "viewer/model/work/results.hpp"

namespace glassbox {

/// What the tasks share.
struct Tools {
    std::function<void()> wake;  ///< called from other threads whenever there is something new
    KeptEngine engine = {};
    learn::mine::Maker maker = {};                           ///< one thread's at a time
    learn::mine::Maker recorder = {};                        ///< another one's
    std::atomic<int> mine_asked = {};                        ///< how often the maker was asked for a picture
    std::atomic<int> mine_made = {};                         ///< up to which of them it is done
    std::atomic<std::int64_t> pixels_done = {};              ///< of the picture that is being rendered
    Thumbnails thumbnails = {};                              ///< one thread's at a time
    std::shared_ptr<const SurfacesInPicture> surfaces = {};  ///< the last that were found; one thread's at a time
};

/// What a task has while it runs.
struct Run {
    Tools& tools;
    Pace& pace;  ///< of its earlier runs
    const std::stop_token& stop;
    bool follows_view = false;  ///< the request is as before but for the view, its light, or how it is traced
};

/// A thread for one task, and what it was last asked for. A task is a struct without values:
///
///   Request, Result: types; requests can be compared
///   wanted(state): the request that the state makes, perhaps none
///   goes_on(before, now): whether what comes of the one request is still worth showing for the other; without it, not
///   follows_view(before, now): see Run; without it, never
///   announce(tools): called as it is asked, before the thread knows; not needed
///   withdraw(tools): called as it is asked no more, and perhaps never performed; not needed
///   perform(request, run, deliver): in the thread; delivers results, each better than the one before
///   tidy(state, results, is_new): takes away what does not belong to the state, whose request may be new; not needed
///   show(result, results)
template <class Task>
class Worker {
public:
    explicit Worker(Tools& tools) : tools_(tools), latest_(tools.wake) {}

    /// Starts what is missing for this state, and stops what is not needed any more.
    void ask(const ViewerState& state, Results& results) {
        std::optional<Request> wanted = Task::wanted(state);
        const bool is_new = wanted != asked_;
        if (is_new) {
            const bool goes_on = asked_ && wanted && may_go_on(*asked_, *wanted);
            const bool follows = asked_ && wanted && follows_view(*asked_, *wanted);
            asked_ = std::move(wanted);
            if (asked_) start(*asked_, goes_on, follows);
            else cancel();
        }
        if constexpr (requires { &Task::tidy; }) Task::tidy(state, results, is_new);
    }

    /// Shows what has come since the last time.
    void take(Results& results) {
        if (auto result = latest_.take()) Task::show(std::move(*result), results);
    }

    bool busy() const { return latest_.busy(); }
    std::string error() const { return latest_.error(); }

private:
    using Request = typename Task::Request;

    static bool may_go_on(const Request& before, const Request& now) {
        if constexpr (requires { &Task::goes_on; }) return Task::goes_on(before, now);
        else return false;
    }

    static bool follows_view(const Request& before, const Request& now) {
        if constexpr (requires { &Task::follows_view; }) return Task::follows_view(before, now);
        else return false;
    }

    void start(const Request& wanted, bool goes_on, bool follows) {
        if constexpr (requires { &Task::announce; }) Task::announce(tools_);
        auto work = [this, wanted, follows](const std::stop_token& stop, const auto& deliver) {
            Task::perform(wanted, Run{tools_, pace_, stop, follows}, deliver);
        };
        latest_.ask(std::move(work), goes_on);
    }

    void cancel() {
        if constexpr (requires { &Task::withdraw; }) Task::withdraw(tools_);
        latest_.cancel();
    }

    Tools& tools_;
    Pace pace_;  // the thread's
    std::optional<Request> asked_;
    Latest<typename Task::Result> latest_;  // last: its thread uses the others
};

/// A worker for each task.
template <class... Tasks>
class Workers {
public:
    explicit Workers(const std::function<void()>& wake) : tools_{wake}, workers_(for_task<Tasks>(tools_)...) {}

    /// As Background::update; of two errors the later task's is told.
    void update(const ViewerState& state, Results& results) {
        each([&](auto& worker) { worker.ask(state, results); });
        // Read before anything is taken: what ends in between counts as still busy, and is there at the next update.
        results.busy = false;
        each([&](const auto& worker) { results.busy = worker.busy() || results.busy; });
        each([&](auto& worker) { worker.take(results); });
        results.error.clear();
        each([&](const auto& worker) {
            if (const std::string error = worker.error(); !error.empty()) results.error = error;
        });
    }

    template <class Task>
    bool busy() const {
        return std::get<Worker<Task>>(workers_).busy();
    }
    const Tools& tools() const { return tools_; }

private:
    template <class>
    static Tools& for_task(Tools& tools) {
        return tools;
    }
    template <class Do>
    void each(const Do& act) {
        std::apply([&](auto&... worker) { (act(worker), ...); }, workers_);
    }

    Tools tools_;
    std::tuple<Worker<Tasks>...> workers_;  // last: their threads use the tools
};

}  // namespace glassbox
