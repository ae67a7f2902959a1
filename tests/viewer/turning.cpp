// While the view turns: the engine stays, a picture is shown for each turn, and what takes long waits until it rests.
#include <doctest.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "viewer/model/work/at_rest.hpp"
#include "viewer/model/work/kept_engine.hpp"
#include "viewer/model/work/picture_tasks.hpp"
#include "viewer/model/work/pixel_task.hpp"
#include "viewer/model/work/surfaces_task.hpp"

using namespace glassbox;

namespace {

/// What a task's thread has, and a request to stop.
struct Thread {
    Tools tools{[] {}};
    Pace pace;
    std::stop_source source;
    std::stop_token stop = source.get_token();

    Run run(bool follows_view = false) { return {tools, pace, stop, follows_view}; }
    /// Whether work is done, or given up because it was asked to stop.
    bool does(bool follows_view) {
        bool done = false;
        try {
            do_at_rest(run(follows_view), [&] { done = true; });
        } catch (const Cancelled&) {
            CHECK_FALSE(done);
        }
        return done;
    }
};

ViewerState state_of_sphere(int width, int height) {
    Scene scene;
    scene.width = width;
    scene.height = height;
    scene.spheres = {{{100, 250, 250}, 100, {200, 0, 0}}};
    ViewerState state;
    state.scene = std::make_shared<const Scene>(scene);
    state.setup = History(setup_of(scene));
    return state;
}

void turn(ViewerState& state) { state.setup.amend(turned(state.setup.now(), Axis::z, 1)); }

}  // namespace

TEST_CASE("turning does not build the engine again; another scene does") {
    Thread thread;
    ViewerState state = state_of_sphere(64, 64);
    const auto engine = [&] { return background_job(picture_request(state), thread.run()).engine; };
    const auto first = engine();
    turn(state);
    CHECK(engine() == first);
    state.scene = std::make_shared<const Scene>(*state.scene);
    CHECK(engine() != first);
}

// By then something newer is wanted each time: still one picture a turn is finished, and none after it.
TEST_CASE("each turn is seen, if only coarsely") {
    Thread thread;
    ViewerState state = state_of_sphere(1600, 1600);
    thread.source.request_stop();
    std::vector<int> factors;
    for (int i = 0; i < 3; ++i) {
        turn(state);
        const std::size_t before = factors.size();
        try {
            RenderPicture::perform(picture_request(state), thread.run(),
                                   [&](const Picture& picture) { factors.push_back(picture.factor); });
        } catch (const Cancelled&) {
        }
        CHECK(factors.size() == before + 1);
    }
}

TEST_CASE("what took long the last time is not done while the view turns") {
    Thread thread;
    thread.source.request_stop();  // as at the next turn
    CHECK_FALSE(thread.does(true));
    CHECK(thread.does(false));  // not because of a turn; and it is quick
    CHECK(thread.does(true));
    thread.pace = Pace();
    thread.pace.note(1, 0.02);
    CHECK_FALSE(thread.does(true));
    CHECK(thread.pace.seconds(1) == 0.02);
}

TEST_CASE("what took long is done once the view rests, and how long it takes now is what counts") {
    Thread thread;
    thread.pace.note(1, 0.02);
    CHECK(thread.does(true));
    CHECK(thread.pace.seconds(1) < 0.02);
    do_at_rest(thread.run(), [] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); });
    CHECK(thread.pace.seconds(1) >= 0.03);  // not 1.25 times what it was
}

TEST_CASE("a story and the surfaces follow the view; another pixel's story is wanted at once") {
    ViewerState state = state_of_sphere(64, 64);
    state.pinned = Pixel{3, 4};
    state.pointed_surface = 0;
    const auto story = *ExplainPinned::wanted(state);
    const auto surfaces = *FindSurfaces::wanted(state);
    turn(state);
    CHECK(ExplainPinned::follows_view(story, *ExplainPinned::wanted(state)));
    CHECK(FindSurfaces::follows_view(surfaces, *FindSurfaces::wanted(state)));
    state.pinned = Pixel{5, 4};
    CHECK_FALSE(ExplainPinned::follows_view(story, *ExplainPinned::wanted(state)));
    state.scene = std::make_shared<const Scene>(*state.scene);
    CHECK_FALSE(FindSurfaces::follows_view(surfaces, *FindSurfaces::wanted(state)));
}
