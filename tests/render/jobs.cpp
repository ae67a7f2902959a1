// Long work: the same bits for any number of threads, with progress, and stopped on request.
#include <doctest.h>

#include <atomic>
#include <thread>

#include "render/render.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

TEST_CASE("the picture has the same bytes whatever the number of threads") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    const Image one = render(scene, {}, {1, {}, nullptr});
    for (const int threads : {2, 3, 8, 0}) {
        CAPTURE(threads);
        CHECK(render(scene, {}, {threads, {}, nullptr}).pixels == one.pixels);
    }
}

TEST_CASE("finished pixels are counted, every one once") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.width = 77;
    scene.height = 45;
    std::atomic<std::int64_t> done = 0;
    render(scene, {}, {0, {}, &done});
    CHECK(done == 77 * 45);
}

TEST_CASE("work that is asked to stop throws Cancelled") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.width = scene.height = 8000;
    std::stop_source source;
    std::atomic<std::int64_t> done = 0;
    const std::jthread impatient([&] {
        while (done == 0) std::this_thread::yield();
        source.request_stop();
    });
    CHECK_THROWS_AS(render(scene, {}, {2, source.get_token(), &done}), Cancelled);
    CHECK(done < std::int64_t{8000} * 8000);
}

TEST_CASE("work that may not stop yet goes on") {
    Scene scene = read_scene(SCENES "/levental-2014.toml");
    scene.width = scene.height = 50;
    std::stop_source source;
    source.request_stop();
    Job job;
    job.stop = source.get_token();
    CHECK_THROWS_AS(render(scene, {}, job), Cancelled);
    job.not_before = std::chrono::steady_clock::now() + std::chrono::hours(1);
    CHECK(render(scene, {}, job).pixels == render(scene, {}).pixels);
}
