// From coarse to fine: which sizes are made, which are shown, and what may be stopped.
#include "viewer/model/work/progressive.hpp"

#include <doctest.h>

#include <chrono>
#include <limits>
#include <thread>
#include <vector>

using namespace glassbox;
using namespace std::chrono_literals;

namespace {

Scene scene_of(int width, int height) {
    Scene scene;
    scene.width = width;
    scene.height = height;
    return scene;
}

struct Made {
    int factor, width, height;
    bool quick;  ///< not to be stopped at once

    bool operator==(const Made&) const = default;
};

/// What is made, and the factors that are shown, if each takes at least this long.
struct Course {
    std::vector<Made> made;
    std::vector<int> shown;
    Pace pace;

    void run(const Scene& scene, std::chrono::milliseconds each, const std::stop_source& stop = {}) {
        Job job;
        job.stop = stop.get_token();
        coarse_to_fine(
            scene, job, pace,
            [&](const Scene& sized, int factor, const Job& its_job) {
                made.push_back({factor, sized.width, sized.height, its_job.not_before > job.not_before});
                std::this_thread::sleep_for(each);
                return factor;
            },
            [&](int factor) { shown.push_back(factor); });
    }
};

}  // namespace

// 60 ms is longer than a frame, so the next size, with four times the pixels, is, too: all of them are wanted.
TEST_CASE("What is slow is shown in every size, and all but the first may be stopped at once") {
    Course course;
    course.run(scene_of(640, 320), 60ms);
    CHECK(course.made ==
          std::vector<Made>{
              {16, 40, 20, true}, {8, 80, 40, false}, {4, 160, 80, false}, {2, 320, 160, false}, {1, 640, 320, false}});
    CHECK(course.shown == std::vector<int>{16, 8, 4, 2, 1});
}

TEST_CASE("The coarsest size has eight pixels on a side; a picture smaller than 16 is whole at once") {
    Course course;
    course.run(scene_of(100, 50), 60ms);
    CHECK(course.shown == std::vector<int>{4, 2, 1});
    Course small;
    small.run(scene_of(15, 200), 60ms);
    CHECK(small.shown == std::vector<int>{1});
}

TEST_CASE("The whole picture comes last, and nothing is made twice") {
    Course course;
    course.run(scene_of(640, 320), 0ms);
    CHECK(course.shown.back() == 1);
    for (std::size_t i = 1; i < course.made.size(); ++i) CHECK(course.made[i].factor < course.made[i - 1].factor);
}

TEST_CASE("Once something newer is wanted nothing more is made, but what is made is shown") {
    std::stop_source stop;
    stop.request_stop();
    Course course;
    CHECK_THROWS_AS(course.run(scene_of(640, 320), 60ms, stop), Cancelled);
    CHECK(course.shown == std::vector<int>{16});
}

// Known to take 30 ms, the half of it is begun with: it is what can be seen 20 times a second.
TEST_CASE("Once it is known what each size takes, the finest that takes less than a frame is made first") {
    Course course;
    course.pace.note(1, 0.1);
    course.pace.note(2, 0.03);
    course.run(scene_of(640, 320), 60ms);
    CHECK(course.shown == std::vector<int>{2, 1});
    CHECK(course.made[0].quick);
    CHECK_FALSE(course.made[1].quick);
    // Now it has taken 60 ms, at any size. Once may be chance: 30 ms become 1.25 · 30 = 37.5, and then 46.9.
    course.shown.clear();
    course.run(scene_of(640, 320), 60ms);
    CHECK(course.shown == std::vector<int>{2, 1});
    course.shown.clear();
    course.run(scene_of(640, 320), 60ms);
    CHECK(course.shown.front() == 16);
}

// 1/8 has taken 20 ms, and now 17: 0.85 of that, as 1/4 will. Then 8.5: half of it, of which 0.8 counts at once, for
// both, so that what was quick once by chance makes no size look slow afterwards.
TEST_CASE("What makes one size quicker or slower is expected to do so to finer ones") {
    Pace pace;
    pace.note(4, 0.05);
    pace.note(8, 0.02);
    CHECK(pace.seconds(4) == 0.05);
    CHECK(pace.finest_within(0.04, 16) == 8);
    pace.note(8, 0.017);
    CHECK(pace.seconds(4) == doctest::Approx(0.85 * 0.05));
    CHECK(pace.finest_within(0.04, 16) == 8);
    pace.note(8, 0.0085);
    CHECK(pace.seconds(8) == doctest::Approx(0.8 * 0.017));
    CHECK(pace.seconds(4) == doctest::Approx(0.8 * 0.85 * 0.05));
    CHECK(pace.finest_within(0.04, 16) == 4);
    // Ten times as long counts as 1.25 times, for both.
    pace.note(8, 0.085);
    CHECK(pace.seconds(8) == doctest::Approx(1.25 * 0.8 * 0.017));
    CHECK(pace.seconds(4) == doctest::Approx(1.25 * 0.8 * 0.85 * 0.05));
    CHECK(pace.seconds(2) == std::numeric_limits<double>::infinity());
    // Nothing is learnt of a coarser one.
    pace.note(4, 0.001);
    CHECK(pace.seconds(8) == doctest::Approx(1.25 * 0.8 * 0.017));
}
