#include "explain/explain.hpp"

#include <utility>

#include "explain/hit_story.hpp"
#include "explain/judgement.hpp"
#include "explain/story_of_pixel.hpp"
#include "explain/surface_kind.hpp"
#include "explain/surface_story.hpp"
#include "explain/traced_pixel.hpp"
#include "render/search/build_engine.hpp"
#include "render/search/surfaces.hpp"

namespace glassbox {

namespace {

/// The most surfaces that a story lists; more only if the ray meets more.
constexpr std::size_t most_surfaces = 20;

/// The surfaces that the judgement is about: they are listed, though they may be missed.
std::vector<std::size_t> besides(const Story& story) {
    std::vector<std::size_t> numbers;
    if (!story.judgement) return numbers;
    if (story.judgement->truth) numbers.push_back(*story.judgement->truth);
    if (story.judgement->least) numbers.push_back(story.judgement->least->surface);
    return numbers;
}

void tell_surfaces(Story& story, const Scene& scene, const engine::Engine& surfaces, const TracedPixel& pixel,
                   const TrueHits& truth, const std::vector<Rgb>& colors, std::optional<ToldTest> test_of_hit) {
    for (const std::size_t number : worth_telling(surfaces, pixel, besides(story), most_surfaces)) {
        std::optional<ToldTest> known;
        if (story.hit && story.hit->surface == number) known = std::move(test_of_hit);
        story::Surface surface = surface_story(surfaces, story.options, pixel, number, std::move(known));
        surface.truly_met = truth.has(number);
        surface.truly_nearest = truth.nearest == number;
        surface.kind = kind_of(scene, number);
        surface.color = colors[number];
        story.surfaces.push_back(std::move(surface));
    }
    story.not_listed = story.in_all - story.surfaces.size();
}

/// Compares what was found with what is true. Returns that.
TrueHits tell_truth(Story& story, const std::shared_ptr<const engine::Engine>& surfaces, const TracedPixel& pixel,
                    Detail detail, const Job& job) {
    if (!is_valid(pixel.ray)) return {};
    TrueHits truth = ReferenceSearch(surfaces).hits(pixel.ray);
    story.judgement = judged(surfaces, story.options, pixel, truth);
    story.judgement->is_weighed = detail == Detail::whole;
    if (detail == Detail::whole) story.judgement->least = least_sure(surfaces, story.options, pixel, job);
    return truth;
}

/// Finds in the surfaces' steps which numbers the judgement is about.
void tell_numbers(story::Judgement& judgement, const std::vector<story::Surface>& rows) {
    if (judgement.least) find_step(*judgement.least, rows);
    const std::optional<std::size_t> wrong = judged_wrongly(judgement);
    for (const story::Surface& surface : rows)
        if (surface.number == wrong) judgement.turned = turned(surface);
}

}  // namespace

Story explain(const Scene& scene, const Options& options, int x, int y, Detail detail, Job job) {
    if (!job.engine) job.engine = build_engine(scene, options.stage, job.threads);
    const engine::Engine& surfaces = *job.engine;
    const TracedPixel said = traced_pixel(scene, options, x, y, job);
    const std::vector<Rgb> colors = surface_colors(scene);

    Story story = story_of_pixel(scene, options, said.ray, x, y);
    story.in_all = surfaces.size();
    story.tested = said.tested;
    story.nodes = said.nodes;
    story.boxes_missed = said.boxes_missed;
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
    if (detail == Detail::recorded || options.stage == 1) return story;
    const TrueHits truth = tell_truth(story, job.engine, said, detail, job);
    tell_surfaces(story, scene, surfaces, said, truth, colors, std::move(test_of_hit));
    if (story.judgement) tell_numbers(*story.judgement, story.surfaces);
    return story;
}

}  // namespace glassbox
