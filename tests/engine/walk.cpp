// Lesson 7's walk through its tree, the engine and the plain loop all find the same surface.
#include <walk.hpp>

#include <doctest.h>

#include <cstdint>
#include <probe.hpp>
#include <random>

#include "render/search/build_engine.hpp"
#include "render/search/fast_search.hpp"
#include "render/search/surfaces.hpp"

using namespace glassbox;

namespace {

/// Random numbers, the same ones on every machine.
class Random {
public:
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    Vec3<double> vector(double size) {
        const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
        return {x, y, z};
    }

private:
    std::mt19937_64 engine_{2014};
};

struct Counting {
    double boxes = 0;

    template <class What, class... Values>
    void operator()(What, const Values&...) {}
    void operator()(told::BoxTested) { ++boxes; }
};

}  // namespace

TEST_CASE("the walk of lesson 7 meets what the engine meets, and the plain loop") {
    Random random;
    Scene scene;
    for (int k = 0; k < 100; ++k) scene.spheres.push_back({random.vector(50), random.between(0.1, 3), {}});
    for (int k = 0; k < 2000; ++k) {
        const Vec3<double> at = random.vector(50);
        scene.triangles.push_back({{at, at + random.vector(4), at + random.vector(4)}, {}});
    }
    const Surfaces<double> all = surfaces<double>(scene, 5);
    std::vector<engine::Box> boxes;
    for (const auto& sphere : all.spheres) boxes.push_back(engine::box_of(sphere, {0, 0, 0}));
    for (const auto& triangle : all.triangles) boxes.push_back(engine::box_of(triangle, {0, 0, 0}));
    const engine::Tree tree = engine::tree_over(boxes);
    const FastSearch certified(build_engine(scene, 5, 1), {}, {});

    const Silent silent;
    Counting counting;
    double tested = 0, met = 0;
    constexpr int rays = 4000;
    for (int n = 0; n < rays; ++n) {
        Ray<double> ray{random.vector(100), random.vector(1)};
        if (n % 4 == 0) ray.D.y = 0;
        if (n % 8 == 0) ray.D.z = 0;
        const auto test = [&](std::size_t surface) {
            return surface < all.spheres.size() ? intersect(ray, all.spheres[surface], Stable{}, silent)
                                                : Pluecker{}(ray, all.triangles[surface - all.spheres.size()], silent);
        };
        std::optional<Hit<double>> plain;
        for (std::size_t k = 0; k < boxes.size(); ++k) plain = nearest(plain, k, test(k));
        const auto walked = engine::walk(
            tree, ray,
            [&](std::size_t surface) {
                ++tested;
                return test(surface);
            },
            counting);
        const auto proven = certified.trace(ray, silent);
        const auto number = [](const auto& hit) { return hit ? static_cast<std::int64_t>(hit->surface) : -1; };
        CHECK(number(walked) == number(plain));
        CHECK(number(walked) == number(proven));
        if (walked && plain) CHECK(walked->t == plain->t);
        met += walked.has_value();
    }
    CHECK(met > rays / 20);  // there is something to meet
    // 2100 surfaces: a few of them, and of their 4000 or so boxes a few dozen
    CHECK(tested / rays < 2100.0 / 100);
    CHECK(counting.boxes / rays < 2100.0 / 20);
}
