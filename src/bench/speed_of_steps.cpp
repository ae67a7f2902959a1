// The numbers of lesson 7: lesson7_steps [RUNS]. First the paper's picture, one change after the other, timed in turn;
// then nanoseconds per ray against the number of triangles, as CSV.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <probe.hpp>
#include <steps.hpp>

#include <tree.hpp>
#include <walk.hpp>

#include "bench/meshes.hpp"
#include "bench/runs.hpp"
#include "bench/trace_certified.hpp"
#include "render/pixel.hpp"
#include "render/render.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/surfaces.hpp"
#include "render/view.hpp"
#include "scene/scene_file.hpp"

using namespace glassbox;

namespace {

constexpr int side = 500;  // the paper's picture

void print_steps(int runs) {
    const Scene scene = read_scene(GLASSBOX_PAPERS_SCENE);
    const auto by_engine = [&](int threads) {
        Options options;
        options.engine = EngineChoice::fast;
        render(scene, options, {threads, {}, nullptr});
    };
    constexpr double rays = side * side;
    std::vector<Work> works;
    for (const Step& step : steps_of_speed()) works.push_back({step.name, rays, [step] { step.draw(side, side); }});
    works.push_back({"the engine, certified, 1 thread", rays, [&] { by_engine(1); }});
    works.push_back({"the engine, certified, all threads", rays, [&] { by_engine(0); }});
    const Speeds speeds = time_in_turn(works, runs);
    fmt::print("The paper's picture, {0} x {0}; {1} runs in turn: median (least ... greatest)\n", side, runs);
    fmt::print("{:<38} {:<28} {:<28} {}\n", "", "million rays a second", "times the line above",
               "times the second line");
    for (std::size_t w = 0; w < works.size(); ++w)
        fmt::print("{:<38} {:<28} {:<28} {}\n", works[w].name, to_text(spread(speeds[w])),
                   w > 0 ? to_text(ratio(speeds[w], speeds[w - 1])) : "",
                   w > 1 ? to_text(ratio(speeds[w], speeds[1])) : "");
}

/// The cost of a ray through one mesh.
void print_costs(const Scene& scene, int runs) {
    const std::vector<Triangle<double>> triangles = surfaces<double>(scene, 5).triangles;
    std::vector<engine::Box> boxes;
    for (const auto& triangle : triangles) boxes.push_back(engine::box_of(triangle, {0, 0, 0}));
    const engine::Tree tree = engine::tree_over(boxes);
    const View seen = view(scene, {});
    Silent silent;
    double sum = 0;  // keeps the compiler from removing the work
    // `count` rays, evenly over the picture
    const auto trace = [&](double count, const auto& nearest_hit) {
        const double step = 1.0 * scene.width * scene.height / count;
        for (double k = 0; k < count; ++k) {
            const auto pixel = static_cast<int>((k + 0.5) * step);
            const Ray<double> ray = pixel_ray(seen, pixel % scene.width, pixel / scene.width, scene.height);
            const auto test = [&](std::size_t surface) { return Pluecker{}(ray, triangles[surface], silent); };
            const auto hit = nearest_hit(ray, test);
            sum += hit ? hit->t : 0;
        }
    };
    const auto plain = [&](const Ray<double>&, const auto& test) {
        std::optional<Hit<double>> best;
        for (std::size_t k = 0; k < triangles.size(); ++k) best = nearest(best, k, test(k));
        return best;
    };
    const auto walk = [&](const Ray<double>& ray, const auto& test) { return engine::walk(tree, ray, test, silent); };
    const double few = std::max(4.0, 4e6 / static_cast<double>(triangles.size())), many = 1 << 16;
    NearestHits hits(pixel_count(scene.width, scene.height));
    const Job one{1, {}, nullptr, build_engine(scene, 5)};
    const Speeds speeds = time_in_turn({{"plain", few, [&] { trace(few, plain); }},
                                        {"walk", many, [&] { trace(many, walk); }},
                                        {"engine", 1.0 * scene.width * scene.height,
                                         [&] { trace_certified(seen, scene.width, scene.height, one, hits); }}},
                                       runs);
    const auto nanoseconds = [&](std::size_t w) { return 1000 / spread(speeds[w]).median; };
    fmt::print("{},{:.4g},{:.4g},{:.4g}\n", triangles.size(), nanoseconds(0), nanoseconds(1), nanoseconds(2));
    if (sum < 0) fmt::print("{}\n", sum);
}

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
    print_steps(runs);
    fmt::print("\nNanoseconds a ray, one thread, 1024 x 1024 rays that all but a few meet an icosphere\n");
    fmt::print("triangles,plain_loop,walk,engine\n");
    for (int splits = 3; splits <= 8; ++splits) print_costs(seen(icosphere(splits), {0, -3, 0}, {0, 0, 0}), runs);
}
