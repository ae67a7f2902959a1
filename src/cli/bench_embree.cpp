#include "cli/bench_embree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
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

/// Some rays of a list, by their places in it, and what the plain loop says that they meet.
struct CheckedRays {
    std::vector<std::size_t> places;
    std::vector<std::uint32_t> met;
};

/// `wanted` rays, evenly from the list; or all where the plain loop takes seconds for them, else 100,000.
CheckedRays check(const Scene& scene, const std::vector<Ray<float>>& list, std::optional<int> wanted, const Job& job) {
    const double triangles = static_cast<double>(scene.meshes.front()->faces.size());
    const auto all = static_cast<double>(list.size());
    double count = all;
    if (all * triangles > 4e9) count = std::min(all, 100'000.0);
    if (wanted) count = std::min<double>(all, *wanted);
    CheckedRays checked;
    std::vector<Ray<double>> rays;
    for (double k = 0; k < count; ++k) {
        const auto place = static_cast<std::size_t>(all / count * k);
        checked.places.push_back(place);
        rays.push_back(convert<double>(list[place]));
    }
    Progress progress("checking", static_cast<std::int64_t>(rays.size()));
    Job shown = job;
    shown.done = &progress.done();
    checked.met = nearest_by_plain_loop(scene, rays, shown);
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

/// Something that is timed, and how many of its answers are wrong.
struct EmbreeRow {
    std::string name;
    bool is_ours;
    std::size_t beside;  ///< the row that its speed is compared with: one of ours, of the same kind of rays
    std::function<void()> run;
    std::function<std::size_t(const CheckedRays&)> count_wrong;
};

/// Rays of one kind, and what traces them.
struct KindOfRays {
    std::string name;
    const std::vector<Ray<float>>& list;
    std::vector<EmbreeRow> rows;
};

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

/// The pixel, row by row, of each place in the list of camera rays.
std::vector<std::size_t> pixels_of_places(int side) {
    std::vector<std::size_t> pixels(pixel_count(side, side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            pixels[place_of_pixel(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))] =
                index_of({x, y}, side);
    return pixels;
}

/// The speeds of all rows, kind by kind; all are timed in turn.
Speeds time_in_turn(const std::vector<KindOfRays>& kinds, int runs) {
    std::vector<Work> works;
    for (const KindOfRays& kind : kinds)
        for (const EmbreeRow& row : kind.rows)
            works.push_back({row.name, static_cast<double>(kind.list.size()), row.run});
    Progress progress("timing", static_cast<std::int64_t>(works.size()) * runs);
    return time_in_turn(works, runs, &progress.done());
}

/// `speeds` are those of the kind's rows.
void print_kind(const KindOfRays& kind, const CheckedRays& checked, const std::vector<double>* speeds,
                BesideEmbree& results) {
    const bool are_all = checked.places.size() == kind.list.size();
    fmt::print("  {}: {}; the plain loop checks {}\n", kind.name, kind.list.size(),
               are_all ? "all" : fmt::to_string(checked.places.size()));
    for (std::size_t i = 0; i < kind.rows.size(); ++i) {
        const EmbreeRow& row = kind.rows[i];
        const std::size_t wrong = row.count_wrong(checked);
        if (row.is_ours && wrong > 0) results.all_right = false;
        std::string comparison;
        if (!row.is_ours)
            comparison = "certified is " + to_text(ratio(speeds[row.beside], speeds[i])) + " times as fast";
        else if (row.beside != i) comparison = to_text(ratio(speeds[i], speeds[row.beside])) + " times one thread";
        fmt::print("    {:<30} {:<26} {:>6} wrong   {}\n", row.name, to_text(spread(nanoseconds(speeds[i]))), wrong,
                   comparison);
    }
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
    const std::vector<std::size_t> pixels = pixels_of_places(side);
    const auto of_list = [](const auto& answers) {
        return [&answers](const CheckedRays& checked) { return count_wrong(checked, answers); };
    };
    const auto of_picture = [&pixels](const NearestHits& hits) {
        return [&pixels, &hits](const CheckedRays& checked) {
            return count_wrong(
                checked, [&](std::size_t place, std::uint32_t met) { return hits.surface[pixels[place]] == met; });
        };
    };
    constexpr auto alike = Coherence::high, scattered = Coherence::none;
    constexpr bool ours = true, theirs = false;
    const std::vector<KindOfRays> kinds{
        {"camera rays",
         camera,
         {
             {"certified, tiles, 1 thread", ours, 0, [&] { trace_certified(view, side, side, one, tiles); },
              of_picture(tiles)},
             {"certified, tiles, all threads", ours, 0, [&] { trace_certified(view, side, side, all, tiles_all); },
              of_picture(tiles_all)},
             {"Embree, robust, packets of 16", theirs, 0, [&] { robust.trace_packets(camera, one, packets); },
              of_list(packets)},
             {"Embree, packets of 16", theirs, 0, [&] { fast.trace_packets(camera, one, fast_packets); },
              of_list(fast_packets)},
             {"certified, ray by ray", ours, 4, [&] { trace_certified(camera, one, alone); }, of_list(alone)},
             {"Embree, robust, ray by ray", theirs, 4, [&] { robust.trace(camera, alike, one, embrees); },
              of_list(embrees)},
             {"Embree, ray by ray", theirs, 4, [&] { fast.trace(camera, alike, one, fast_embrees); },
              of_list(fast_embrees)},
         }},
        {"rays from the surfaces, in all directions",
         ways,
         {
             {"certified, ray by ray", ours, 0, [&] { trace_certified(ways, one, way_hits); }, of_list(way_hits)},
             {"Embree, robust, ray by ray", theirs, 0, [&] { robust.trace(ways, scattered, one, way_embrees); },
              of_list(way_embrees)},
         }},
        {"shadow rays, from the surfaces to a light",
         lit,
         {
             {"certified, any hit", ours, 0, [&] { occluded_certified(lit, one, shadows); }, of_list(shadows)},
             {"Embree, robust, any hit", theirs, 0, [&] { robust.occluded(lit, alike, one, shadows_embrees); },
              of_list(shadows_embrees)},
         }},
    };
    const Speeds speeds = time_in_turn(kinds, runs);

    std::size_t first = 0;
    for (const KindOfRays& kind : kinds) {
        print_kind(kind, check(scene, kind.list, rays_to_check, all), &speeds[first], results);
        first += kind.rows.size();
    }
    results.tiles.take(ratio(speeds[0], speeds[2]), name + ", camera rays");
    results.ray_by_ray.take(ratio(speeds[4], speeds[5]), name + ", camera rays");
    results.ray_by_ray.take(ratio(speeds[7], speeds[8]), name + ", rays from the surfaces");
    results.ray_by_ray.take(ratio(speeds[9], speeds[10]), name + ", shadow rays");
    std::fflush(stdout);
}

}  // namespace

bool bench_against_embree(int runs, std::optional<int> rays_to_check, const std::stop_token& stop) {
    const std::pair<std::string, Scene> scenes[] = {
        {"a knot", seen(trefoil(128, 12), {0, 0, 4}, {0, 0.1, 0})},
        {"an icosphere", seen(icosphere(6), {0, -3, 0}, {0, 0, 0})},
        {"a terrain", a_million_triangles()},
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
