#include "cli/bench_embree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <utility>

#include "bench/against_embree.hpp"
#include "bench/meshes.hpp"
#include "bench/runs.hpp"
#include "cli/progress.hpp"
#include "engine/kernels.hpp"
#include "engine/tile.hpp"
#include "render/parallel.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/certified_search.hpp"
#include "render/view.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

/// Nanoseconds per ray, from million rays per second.
std::vector<double> nanoseconds(std::vector<double> speeds) {
    for (double& speed : speeds) speed = 1000 / speed;
    return speeds;
}

std::size_t differences(const NearestHits& one, const NearestHits& other) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < one.surface.size(); ++i) count += one.surface[i] != other.surface[i];
    return count;
}

/// Compares every n-th hit with the plain loop's, as many as some seconds allow. Returns how many differ and how many
/// were compared.
std::pair<std::size_t, std::size_t> differences_from_plain(const Scene& scene, const NearestHits& hits,
                                                           const Job& job) {
    const std::size_t pixels = hits.surface.size(), triangles = scene.meshes.front()->faces.size();
    const std::size_t step = std::max<std::size_t>(1, pixels * triangles / 4'000'000'000 * 2 + 1);
    const View seen = view(scene, {});
    const CertifiedSearch plain(surfaces<double>(scene, 5), {}, {}, reach(seen, scene.width, scene.height), false);
    std::atomic<std::size_t> wrong = 0;
    const std::size_t rays = (pixels + step - 1) / step;
    for_each_index(rays, job, [&](std::size_t i) {
        const std::size_t pixel = i * step;
        const int x = static_cast<int>(pixel) % scene.width, y = static_cast<int>(pixel) / scene.width;
        const Silent silent;
        const auto hit = plain.trace(pixel_ray(seen, x, y, scene.height), silent);
        if ((hit ? static_cast<std::uint32_t>(hit->surface) : engine::no_surface) != hits.surface[pixel]) ++wrong;
    });
    return {wrong, rays};
}

void print(const std::string& name, const std::vector<double>& speeds, const std::string& comparison = {}) {
    fmt::print("  {:<40} {:<26} {}\n", name, to_text(spread(nanoseconds(speeds))), comparison);
}

}  // namespace

void bench_against_embree(int runs, const std::stop_token& stop) {
    const std::pair<std::string, Scene> scenes[] = {
        {"a knot", seen(trefoil(128, 12), {0, 0, 4}, {0, 0.1, 0})},
        {"an icosphere", seen(icosphere(6), {0, -3, 0}, {0, 0, 0})},
        {"a terrain", seen(terrain(708), {-1.2, -1.5, 0.9}, {0, 0, -0.1})},
    };
    fmt::print("Nanoseconds a ray; {} of each, in turn: median (least ... greatest)\n",
               counted(static_cast<std::size_t>(runs), "run"));
    fmt::print("Glassbox's vectors are {}; Embree is {}\n", engine::vectors_used(), EmbreeScene::version());
    for (const auto& [name, scene] : scenes) {
        const auto triangles = static_cast<double>(scene.meshes.front()->faces.size());
        fmt::print("\n{} of {} triangles, {} x {} pixels\n", name, triangles, scene.width, scene.height);
        const auto start = std::chrono::steady_clock::now();
        const auto engine = build_engine(scene, 5);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        const EmbreeScene robust(scene, true), fast(scene, false);
        fmt::print("  ready in {:.3g} s, {:.3g} bytes a triangle; Embree {:.3g} s, {:.3g} (robust), {:.3g} s, {:.3g}\n",
                   seconds, static_cast<double>(engine->bytes()) / triangles, robust.build_seconds(),
                   robust.bytes() / triangles, fast.build_seconds(), fast.bytes() / triangles);

        const double rays = 1.0 * scene.width * scene.height;
        NearestHits ours(scene), alone(scene), embrees(scene), packets(scene), unsafe(scene);
        const Job one{1, stop, nullptr, engine}, all{0, stop, nullptr, engine};
        const std::vector<Work> works{
            {"certified, 1 thread", rays, [&, &s = scene] { trace_certified(s, one, ours); }},
            {"certified, all threads", rays, [&, &s = scene] { trace_certified(s, all, ours); }},
            {"certified, ray by ray", rays, [&, &s = scene] { trace_certified_one_by_one(s, one, alone); }},
            {"Embree, robust, ray by ray", rays, [&] { robust.trace_one_by_one(one, embrees); }},
            {"Embree, robust, packets of 16", rays, [&] { robust.trace_packets(one, packets); }},
            {"Embree, ray by ray", rays, [&] { fast.trace_one_by_one(one, unsafe); }},
            {"Embree, packets of 16", rays, [&] { fast.trace_packets(one, unsafe); }},
        };
        const Speeds speeds = [&] {
            Progress progress("timing", static_cast<std::int64_t>(works.size()) * runs);
            return time_in_turn(works, runs, &progress.done());
        }();
        print(works[0].name, speeds[0]);
        print(works[1].name, speeds[1], to_text(ratio(speeds[1], speeds[0])) + " times one thread");
        for (std::size_t w = 2; w < works.size(); ++w)
            print(works[w].name, speeds[w], "certified is " + to_text(ratio(speeds[0], speeds[w])) + " times as fast");
        print("(ray by ray, both)", speeds[2], to_text(ratio(speeds[2], speeds[3])) + " times Embree, robust");
        const auto [wrong, checked] = differences_from_plain(scene, ours, all);
        fmt::print(
            "  answers unlike those of the plain loop: {} of {} rays; ray by ray unlike together: {}; Embree's, "
            "robust: {}\n",
            wrong, checked, differences(ours, alone), differences(ours, embrees));
    }
}

}  // namespace glassbox
