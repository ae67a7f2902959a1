#include "cli/bench_embree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "bench/against_embree.hpp"
#include "bench/float_rays.hpp"
#include "bench/meshes.hpp"
#include "bench/plain_loop.hpp"
#include "bench/runs.hpp"
#include "cli/progress.hpp"
#include "engine/kernels.hpp"
#include "engine/tile.hpp"
#include "render/pixel.hpp"
#include "render/search/build_engine.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

/// Nanoseconds per ray, from million rays per second.
std::vector<double> nanoseconds(std::vector<double> speeds) {
    for (double& speed : speeds) speed = 1000 / speed;
    return speeds;
}

/// Some rays of a list, by their places in it, and what the plain loop says that they meet.
struct CheckedRays {
    std::vector<std::size_t> places;
    std::vector<std::uint32_t> met;
};

/// `wanted` rays, evenly from the list; or all where the plain loop takes seconds for them, else 100,000, and where
/// these, too, would take minutes, as many as it can do in some seconds.
CheckedRays check(const Scene& scene, const std::vector<Ray<float>>& list, std::optional<int> wanted, const Job& job) {
    const double triangles = static_cast<double>(scene.meshes.front()->faces.size());
    const auto all = static_cast<double>(list.size());
    double count = all;
    if (all * triangles > 4e9) count = std::min({all, 100'000.0, 8.2e9 / triangles});
    if (wanted) count = std::min<double>(all, *wanted);
    CheckedRays checked;
    std::vector<Ray<double>> rays;
    for (double k = 0; k < count; ++k) {
        const auto place = static_cast<std::size_t>(all / count * k);
        checked.places.push_back(place);
        rays.push_back(convert<double>(list[place]));
    }
    checked.met = nearest_by_plain_loop(scene, rays, job);
    return checked;
}

/// For how many of the checked rays `is_right(place, what is met)` is false.
template <class IsRight>
std::size_t count_wrong(const CheckedRays& checked, const IsRight& is_right) {
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < checked.places.size(); ++k) wrong += !is_right(checked.places[k], checked.met[k]);
    return wrong;
}

std::size_t count_wrong(const CheckedRays& checked, const NearestHits& hits) {
    return count_wrong(checked, [&](std::size_t place, std::uint32_t met) { return hits.surface[place] == met; });
}

std::size_t count_wrong(const CheckedRays& checked, const std::vector<std::uint8_t>& occluded) {
    return count_wrong(checked, [&](std::size_t place, std::uint32_t met) {
        return (occluded[place] != 0) == (met != engine::no_surface);
    });
}

/// The least ratio of speeds so far, and of what.
struct Least {
    double ratio = std::numeric_limits<double>::infinity();
    std::string what;

    void take(const Spread& ratios, const std::string& of) {
        if (ratios.median < ratio) *this = {ratios.median, of};
    }
};

struct BesideEmbree {
    Least ray_by_ray, tiles;
    bool all_right = true;
};

void print(const Work& work, const std::vector<double>& speeds, std::size_t wrong, const std::string& comparison) {
    fmt::print("    {:<30} {:<26} {:>6} wrong   {}\n", work.name, to_text(spread(nanoseconds(speeds))), wrong,
               comparison);
}

std::string times_as_fast(const Spread& ratios) { return "certified is " + to_text(ratios) + " times as fast"; }

/// Builds it several times, and prints how long that takes.
std::shared_ptr<const engine::Engine> build(const Scene& scene, const EmbreeScene& robust, const EmbreeScene& fast) {
    const auto triangles = static_cast<double>(scene.meshes.front()->faces.size());
    std::shared_ptr<const engine::Engine> engine;
    std::vector<double> seconds;
    for (int i = 0; i < 5; ++i) {
        const auto start = std::chrono::steady_clock::now();
        engine = build_engine(scene, 5);
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    fmt::print("  ready in {} s, {:.3g} bytes a triangle; Embree {:.3g} s, {:.3g} (robust), {:.3g} s, {:.3g}\n",
               to_text(spread(seconds)), static_cast<double>(engine->bytes()) / triangles, robust.build_seconds(),
               robust.bytes() / triangles, fast.build_seconds(), fast.bytes() / triangles);
    return engine;
}

void bench_mesh(const std::string& name, const Scene& scene, int runs, std::optional<int> rays_to_check,
                const std::stop_token& stop, BesideEmbree& results) {
    const int side = scene.width;
    fmt::print("\n{} of {} triangles\n", name, scene.meshes.front()->faces.size());
    const EmbreeScene robust(scene, true), fast(scene, false);
    const auto engine = build(scene, robust, fast);
    const Job one{1, stop, nullptr, engine}, all{0, stop, nullptr, engine};

    const FromEye view = view_in_floats(scene);
    const std::vector<Ray<float>> camera = camera_rays(view, side);
    NearestHits alone(camera.size());
    trace_certified(camera, all, alone);
    const RaysFromSurfaces from_surfaces = rays_from_surfaces(scene, camera, alone.surface, {0.6f, -0.5f, 0.4f});
    const auto& ways = from_surfaces.all_ways;
    const auto& lit = from_surfaces.towards_light;

    // The hits of tiles are in the order of pixels, all others in that of the lists of rays.
    NearestHits tiles(camera.size()), tiles_all(camera.size()), packets(camera.size()), fast_packets(camera.size());
    NearestHits embrees(camera.size()), fast_embrees(camera.size()), way_hits(ways.size()), way_embrees(ways.size());
    std::vector<std::uint8_t> shadows(lit.size()), shadows_embrees(lit.size());
    const auto rays = static_cast<double>(camera.size()), others = static_cast<double>(ways.size());
    constexpr auto near_each_other = Coherence::high, scattered = Coherence::none;
    const std::vector<Work> works{
        {"certified, tiles, 1 thread", rays, [&] { trace_certified(view, side, side, one, tiles); }},
        {"certified, tiles, all threads", rays, [&] { trace_certified(view, side, side, all, tiles_all); }},
        {"Embree, robust, packets of 16", rays, [&] { robust.trace_packets(camera, one, packets); }},
        {"Embree, packets of 16", rays, [&] { fast.trace_packets(camera, one, fast_packets); }},
        {"certified, ray by ray", rays, [&] { trace_certified(camera, one, alone); }},
        {"Embree, robust, ray by ray", rays, [&] { robust.trace(camera, near_each_other, one, embrees); }},
        {"Embree, ray by ray", rays, [&] { fast.trace(camera, near_each_other, one, fast_embrees); }},
        {"certified, ray by ray", others, [&] { trace_certified(ways, one, way_hits); }},
        {"Embree, robust, ray by ray", others, [&] { robust.trace(ways, scattered, one, way_embrees); }},
        {"certified, any hit", others, [&] { occluded_certified(lit, one, shadows); }},
        {"Embree, robust, any hit", others, [&] { robust.occluded(lit, near_each_other, one, shadows_embrees); }},
    };
    const Speeds speeds = [&] {
        Progress progress("timing", static_cast<std::int64_t>(works.size()) * runs);
        return time_in_turn(works, runs, &progress.done());
    }();

    const auto ours = [&](std::size_t w, std::size_t wrong, const std::string& comparison = {}) {
        results.all_right = results.all_right && wrong == 0;
        print(works[w], speeds[w], wrong, comparison);
    };
    const auto theirs = [&](std::size_t w, std::size_t wrong, std::size_t beside) {
        print(works[w], speeds[w], wrong, times_as_fast(ratio(speeds[beside], speeds[w])));
    };
    const auto heading = [](const std::string& what, std::size_t count, const CheckedRays& checked) {
        const bool are_all = checked.places.size() == count;
        fmt::print("  {}: {}; the plain loop checks {}\n", what, count,
                   are_all ? "all" : fmt::to_string(checked.places.size()));
    };

    const CheckedRays of_camera = check(scene, camera, rays_to_check, all);
    std::vector<std::size_t> pixels(camera.size());
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            pixels[place_of_pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))] =
                index_of({x, y}, side);
    const auto wrong_in = [&](const NearestHits& picture) {
        return count_wrong(of_camera,
                           [&](std::size_t place, std::uint32_t met) { return picture.surface[pixels[place]] == met; });
    };
    heading("camera rays", camera.size(), of_camera);
    ours(0, wrong_in(tiles));
    ours(1, wrong_in(tiles_all), to_text(ratio(speeds[1], speeds[0])) + " times one thread");
    theirs(2, count_wrong(of_camera, packets), 0);
    theirs(3, count_wrong(of_camera, fast_packets), 0);
    ours(4, count_wrong(of_camera, alone));
    theirs(5, count_wrong(of_camera, embrees), 4);
    theirs(6, count_wrong(of_camera, fast_embrees), 4);

    const CheckedRays of_ways = check(scene, ways, rays_to_check, all);
    heading("rays from the surfaces, in all directions", ways.size(), of_ways);
    ours(7, count_wrong(of_ways, way_hits));
    theirs(8, count_wrong(of_ways, way_embrees), 7);

    const CheckedRays of_shadows = check(scene, lit, rays_to_check, all);
    heading("shadow rays, from the surfaces to a light", lit.size(), of_shadows);
    ours(9, count_wrong(of_shadows, shadows));
    theirs(10, count_wrong(of_shadows, shadows_embrees), 9);

    results.tiles.take(ratio(speeds[0], speeds[2]), name + ", camera rays");
    results.ray_by_ray.take(ratio(speeds[4], speeds[5]), name + ", camera rays");
    results.ray_by_ray.take(ratio(speeds[7], speeds[8]), name + ", rays from the surfaces");
    results.ray_by_ray.take(ratio(speeds[9], speeds[10]), name + ", shadow rays");
}

}  // namespace

bool bench_against_embree(int runs, std::optional<int> rays_to_check, const std::stop_token& stop) {
    const std::pair<std::string, Scene> scenes[] = {
        {"a knot", seen(trefoil(128, 12), {0, 0, 4}, {0, 0.1, 0})},
        {"an icosphere", seen(icosphere(6), {0, -3, 0}, {0, 0, 0})},
        {"a terrain", seen(terrain(708), {-1.2, -1.5, 0.9}, {0, 0, -0.1})},
    };
    fmt::print("Nanoseconds a ray; {} of each, in turn: median (least ... greatest)\n",
               counted(static_cast<std::size_t>(runs), "run"));
    fmt::print("Glassbox's vectors are {}; Embree is {}; both answer for the same rays, on one thread if not said\n",
               engine::vectors_used(), EmbreeScene::version());
    fmt::print("Wrong is what differs from the plain certified loop: another surface, or a hit for a miss\n");
    BesideEmbree results;
    for (const auto& [name, scene] : scenes) bench_mesh(name, scene, runs, rays_to_check, stop, results);
    fmt::print("\nWhat Glassbox answered is {}.\nCertified's speed over that of Embree, robust:\n",
               results.all_right ? "right in all rays that were checked" : "WRONG somewhere: see above");
    fmt::print("least ratio: {:.2f} (ray by ray: {})\n", results.ray_by_ray.ratio, results.ray_by_ray.what);
    fmt::print("least ratio: {:.2f} (tiles: {})\n", results.tiles.ratio, results.tiles.what);
    return results.all_right;
}

}  // namespace glassbox
