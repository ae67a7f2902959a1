#include "explain/explain.hpp"

#include <utility>

#include "explain/hit_story.hpp"
#include "explain/surface_kind.hpp"
#include "explain/surface_story.hpp"
#include "explain/traced_pixel.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

namespace {

/// The most surfaces that a story lists; more only if the ray meets more.
constexpr std::size_t most_surfaces = 20;

bool is_on_border(const Scene& scene, int x, int y) {
    return scene.border && (x == 0 || y == 0 || x == scene.width - 1 || y == scene.height - 1);
}

void tell_surfaces(Story& story, const Scene& scene, const engine::Engine& surfaces, const TracedPixel& pixel,
                   const std::vector<Rgb>& colors, std::optional<ToldTest> test_of_hit) {
    for (const std::size_t number : worth_telling(surfaces, pixel, most_surfaces)) {
        std::optional<ToldTest> known;
        if (story.hit && story.hit->surface == number) known = std::move(test_of_hit);
        story::Surface surface = surface_story(surfaces, story.options, pixel, number, std::move(known));
        surface.kind = kind_of(scene, number);
        surface.color = colors[number];
        story.surfaces.push_back(std::move(surface));
    }
    story.not_listed = story.tested - story.surfaces.size();
}

}  // namespace

Story explain(const Scene& scene, const Options& options, int x, int y, Detail detail, Job job) {
    if (!job.engine) job.engine = build_engine(scene, options.stage, job.threads);
    const engine::Engine& surfaces = *job.engine;
    const TracedPixel said = traced_pixel(scene, options, x, y, job);
    const std::vector<Rgb> colors = surface_colors(scene);

    Story story;
    story.title = scene.title;
    story.width = scene.width;
    story.height = scene.height;
    story.x = story.column = x;
    story.y = y;
    story.row = scene.height - 1 - y;
    story.options = options;
    story.ray = said.ray;
    story.tested = surfaces.size();
    story.met = said.met.size();
    story.traced = scene.background;
    std::optional<ToldTest> test_of_hit;
    if (options.stage == 1) {
        auto [color, rounded, steps, calls] = ray_story(said, options.scalar, story.column, story.row, detail);
        story.ray_color = color;
        story.ray_steps = std::move(steps);
        story.ray_calls = std::move(calls);
        story.traced = rounded;
    } else if (said.nearest) {
        auto [hit, color, test] = hit_story(scene, surfaces, options, said, colors[said.nearest->surface], detail);
        story.hit = std::move(hit);
        story.traced = color;
        test_of_hit = std::move(test);
    }
    story.border = is_on_border(scene, x, y);
    story.color = story.border ? *scene.border : story.traced;
    if (detail == Detail::whole && options.stage > 1)
        tell_surfaces(story, scene, surfaces, said, colors, std::move(test_of_hit));
    return story;
}

}  // namespace glassbox
