#include <fmt/format.h>

#include <array>
#include <baseline.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/runs.hpp"
#include "cli/bench_cliffs.hpp"
#include "cli/bench_embree.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "render/render.hpp"
#include "render/search/surfaces.hpp"
#include "render/typed.hpp"
#include "scene/printable.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_path.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

namespace {

struct BenchRequest {
    std::vector<std::string> scenes{"levental-2014", "room"};
    std::optional<int> runs;
    bool against_embree = false, cliffs = false, markdown = false;
    std::optional<int> rays_to_check;
    std::string only;

    int runs_or(int usual) const { return runs.value_or(usual); }
};

void print(const std::string& name, const std::vector<double>& speeds, const std::string& comparison = {}) {
    fmt::print("  {:<34} {:<26} {}\n", name, to_text(spread(speeds)), comparison);
}

std::string times(const std::vector<double>& one, const std::vector<double>& other, const std::string& what) {
    return to_text(ratio(one, other)) + " times " + what;
}

Work rendering(const Scene& scene, Scalar scalar, const std::string& name, const Job& job) {
    Options options;
    options.scalar = scalar;
    return {name, 1.0 * scene.width * scene.height, [&scene, options, job] { render(scene, options, job); }};
}

Speeds timed(const std::vector<Work>& works, int runs) {
    Progress progress("timing", static_cast<std::int64_t>(works.size()) * runs);
    return time_in_turn(works, runs, &progress.done());
}

Work counting(const Scene& scene, const std::string& name, const Job& job) {
    const std::array<const Measurement*, 2> counts{find_measurement("tests"), find_measurement("hits")};
    return {name, 1.0 * scene.width * scene.height, [&scene, counts, job] { measure(scene, {}, counts, job); }};
}

void bench_scene(const std::string& name, const Scene& scene, int runs, const std::stop_token& stop) {
    const Surfaces<double> all = surfaces<double>(scene, 5);
    const std::size_t count = all.spheres.size() + all.triangles.size();
    fmt::print("\n{}: {} x {} pixels, {} surfaces\n", printable(name), scene.width, scene.height, count);
    const bool papers = name == "levental-2014";
    std::vector<Work> works{
        rendering(scene, Scalar::double_, "picture in double, 1 thread", {1, stop, nullptr}),
        rendering(scene, Scalar::double_, "picture in double, all threads", {0, stop, nullptr}),
        rendering(scene, Scalar::certified, "picture certified, 1 thread", {1, stop, nullptr}),
        counting(scene, "tests and hits counted, 1 thread", {1, stop, nullptr}),
    };
    if (papers)
        works.push_back({"the paper's program, 1 thread", 1.0 * scene.width * scene.height,
                         [&scene] { render_as_published(scene.width, scene.height, .2, 1, .2); }});
    const Speeds speeds = timed(works, runs);
    if (papers) print(works[4].name, speeds[4]);
    print(works[0].name, speeds[0], papers ? times(speeds[0], speeds[4], "the paper's program") : "");
    print(works[1].name, speeds[1], times(speeds[1], speeds[0], "one thread"));
    print(works[2].name, speeds[2],
          papers ? times(speeds[2], speeds[4], "the paper's program") : times(speeds[2], speeds[0], "double"));
    print(works[3].name, speeds[3], "takes " + times(speeds[2], speeds[3], "as long as the picture, certified"));
}

}  // namespace

void add_bench(CLI::App& program, Session& session) {
    const auto request = std::make_shared<BenchRequest>();
    CLI::App* command =
        program.add_subcommand("bench", "Measure speed: million rays a second, and what it compares with");
    command->add_option("SCENE", request->scenes, "scenes to trace (default: levental-2014 room)");
    const auto read_runs = [request](const std::string& typed) {
        request->runs = whole_number("--runs", typed, 1, 1000);
    };
    command
        ->add_option_function<std::string>("--runs", read_runs,
                                           "how many runs of each, in turn (default: 7; 9 against Embree, 5 of cliffs)")
        ->type_name("N");
    const auto read_against = [request](const std::string& typed) {
        if (typed != "embree") throw wrong("--against", fmt::format("'{}' is not known; it must be embree", typed));
        request->against_embree = true;
    };
    command
        ->add_option_function<std::string>("--against", read_against,
                                           "another tracer, on generated meshes: embree, where it was installed")
        ->type_name("embree");
    command->add_flag("--cliffs", request->cliffs,
                      "scenes and rays that could cost many times what ordinary ones do, beside these");
    command->add_option("--only", request->only, "of --cliffs, only the cases whose names contain this")
        ->type_name("TEXT");
    command->add_flag("--markdown", request->markdown, "the table of --cliffs for a page");
    const auto read_checked = [request](const std::string& typed) {
        request->rays_to_check = whole_number("--check", typed, 1, 1'000'000'000);
    };
    command
        ->add_option_function<std::string>("--check", read_checked,
                                           "how many rays the plain loop checks, of cliffs and of each kind of rays "
                                           "against Embree (default: as many as take it some seconds)")
        ->type_name("N");
    command->callback([request, &session] {
        if (request->against_embree) {
            const bool all_right =
                bench_against_embree(request->runs_or(9), request->rays_to_check, session.interrupt.token());
            if (!all_right) throw CLI::RuntimeError(1);
            return;
        }
        if (request->cliffs) {
            const CliffRequest cliffs{request->runs_or(5), request->rays_to_check, request->only, request->markdown};
            if (!bench_cliffs(cliffs, session.interrupt.token())) throw CLI::RuntimeError(1);
            return;
        }
        const int runs = request->runs_or(7);
        std::vector<Scene> scenes;  // reads all before timing the first, so that a wrong name costs no minutes
        for (const std::string& name : request->scenes) scenes.push_back(read_scene(scene_path(name)));
        fmt::print("Million rays a second; {} of each, in turn: median (least ... greatest)\n",
                   counted(static_cast<std::size_t>(runs), "run"));
        for (std::size_t i = 0; i < scenes.size(); ++i)
            bench_scene(request->scenes[i], scenes[i], runs, session.interrupt.token());
    });
}

}  // namespace glassbox
