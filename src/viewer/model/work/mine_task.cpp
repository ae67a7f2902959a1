#include "viewer/model/work/mine_task.hpp"

#include <chrono>
#include <exception>
#include <string>
#include <thread>
#include <utility>

namespace glassbox {

namespace {

/// At its end, whatever had been asked for when it began counts as done, also a later request that is yet to be
/// performed.
class AtWork {
public:
    explicit AtWork(Tools& tools) : tools_(tools), asked_(tools.mine_asked) {}
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
    ~AtWork() {
        int made = tools_.mine_made;  // more than what was asked where a later one was withdrawn meanwhile
        while (made < asked_ && !tools_.mine_made.compare_exchange_weak(made, asked_)) {
        }
    }

private:
    Tools& tools_;
    int asked_;
};

}  // namespace

void DrawMine::perform(const Request& request, const Run& run, const std::function<void(Result)>& deliver) {
    const auto tell = [&](learn::mine::PictureUpdate update) {
        deliver(std::make_shared<const learn::mine::PictureUpdate>(std::move(update)));
    };
    const AtWork at_work(run.tools);
    const auto& [seen, workspace, chosen, saved] = request;
    const Scene scene = applied(*seen.scene, seen.setup);
    learn::mine::Maker& maker = run.tools.maker;
    try {
        if (const int* const lesson = std::get_if<int>(&chosen))
            maker.make(*workspace, {&learn::exercise_called(*workspace, std::to_string(*lesson))}, scene,
                       seen.setup.options, tell, run.stop);
        else maker.make_with_all(*workspace, scene, seen.setup.options, tell, run.stop);
    } catch (const std::exception& error) {  // the machine cannot do it
        learn::mine::PictureUpdate update;
        update.stand = learn::mine::Stand::not_there;
        update.words = error.what();
        tell(std::move(update));
    }
}

void wait_for_picture(const Run& run) {
    constexpr std::chrono::milliseconds a_moment{10};
    const int asked = run.tools.mine_asked;
    while (run.tools.mine_made < asked && !run.stop.stop_requested()) std::this_thread::sleep_for(a_moment);
}

void DrawMine::tidy(const ViewerState& state, Results& results, bool) {
    const bool shown = shows_mine(state);
    if (!shown && results.mine) results.mine = nullptr, results.other = {};
    if (!shown) return;
    const auto& last = results.other.image;
    if (!results.mine || (last && (last->width != state.scene->width || last->height != state.scene->height)))
        results.other = {};
    if (!results.mine) results.mine = std::make_shared<const learn::mine::PictureUpdate>();
}

void DrawMine::show(Result update, Results& results) {
    results.mine = std::move(update);
    ++results.mine_serial;
    const auto& drawing = results.mine->drawing;
    if (!drawing) return;
    const bool whole = results.mine->stand == learn::mine::Stand::drawn;
    results.other = {std::shared_ptr<const Image>(drawing, &drawing->image), whole ? 1 : 2};
    ++results.other_serial;
}

}  // namespace glassbox
