#include "explain/json.hpp"

#include <nlohmann/json.hpp>

#include "explain/phrases.hpp"
#include "explain/scalar_of_steps.hpp"
#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "render/option_names.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;
using namespace story;

constexpr int version = 2;

/// JSON has no infinity or NaN: they become null.
Json json(const Number& n) {
    return {{"value", n.value}, {"hex", hex(n.recorded)},   {"error", n.error},
            {"true", n.truth},  {"true_hex", hex(n.truth)}, {"off", n.distance},
            {"sign", n.sign},   {"bits_lost", n.bits_lost}, {"known", word(n.known)}};
}
Json json(const std::optional<std::size_t>& n) { return n ? Json(*n) : Json(nullptr); }
Json json(const std::optional<StepNumber>& n) { return n ? Json(*n) : Json(nullptr); }
Json json(const std::optional<Number>& n) { return n ? json(*n) : Json(nullptr); }
Json json(const Vector& v) { return Json::array({json(v.x), json(v.y), json(v.z)}); }
Json json(const Vec3<double>& v) { return Json::array({v.x, v.y, v.z}); }
Json json(Rgb c) { return Json::array({c.red, c.green, c.blue}); }
Json hexes(const Vec3<double>& v) { return Json::array({hex(v.x), hex(v.y), hex(v.z)}); }

Json json(const RootPair& roots) {
    return {{"discriminant", json(roots.discriminant)}, {"t0", json(roots.t0)}, {"t1", json(roots.t1)}};
}

void add_test(Json& row, const SphereTest& test) {
    row["center"] = json(test.center);
    row["radius"] = test.radius;
    row["textbook"] = json(test.textbook);
    row["stable"] = json(test.stable);
}

void add_test(Json& row, const TriangleTest& test) {
    row["vertices"] = Json::array({json(test.vertices[0]), json(test.vertices[1]), json(test.vertices[2])});
    row["sides"] = {{"a", json(test.a)}, {"b", json(test.b)}, {"c", json(test.c)}};
    row["sum"] = json(test.sum);
    row["deficit"] = json(test.deficit);
    row["tolerance"] = test.tolerance;
    row["tolerance_accepts"] = test.accepted;
    row["weights"] = nullptr;
    if (test.weights) {
        const auto& [a, b, c] = *test.weights;
        row["weights"] = {{"A", json(a)}, {"B", json(b)}, {"C", json(c)}};
    }
}

Json json(const Judgement& judgement) {
    return {{"surface", json(judgement.truth)},
            {"shown_is_there", judgement.shown_is_there},
            {"at_once", judgement.at_once},
            {"wrongly_met", judgement.wrongly_met},
            {"wrongly_missed", judgement.wrongly_missed},
            {"by_rule", judgement.by_rule},
            {"turned", judgement.turned}};
}

Json json(const LeastSure& least) {
    return {{"margin", margin(least)},
            {"proven", least.sureness > 1},
            {"surface", least.surface},
            {"nearer_than", json(least.nearer_than)},
            {"name", least.name},
            {"row", json(least.row)},
            {"step", json(least.step)},
            {"worst_step", json(least.worst)},
            {"worst_bits", least.worst_loss}};
}

Json json(const Surface& surface) {
    Json row = {{"surface", surface.number},
                {"kind", word(surface.kind)},
                {"color", json(surface.color)},
                {"met", is_met(surface.fate)},
                {"fate", word(surface.fate)},
                {"truly_met", surface.truly_met},
                {"truly_nearest", surface.truly_nearest},
                {"decided", surface.needed_exact ? "exact" : "filter"},
                {"t", json(surface.t)}};
    std::visit([&](const auto& test) { add_test(row, test); }, surface.test);
    return row;
}

Json json(const Term& term) {
    return {{"k", term.k},
            {"factor", json(term.factor)},
            {"color", json(term.color)},
            {"product", json(term.product)},
            {"bytes", json(term.bytes)}};
}

Json json(const Shade& shade) {
    const bool phong = shade.model == ShadingModel::phong;
    return {{"model", name_of(shade.model)},
            {"intensity", shade.intensity},
            {"exponent", shade.exponent},
            {"L", json(shade.L)},
            {"l", json(shade.l)},
            {"r", json(shade.r)},
            {"n_l", json(shade.n_l)},
            {"n_r", json(shade.n_r)},
            {phong ? "reflection" : "half_vector", json(shade.h)},
            {phong ? "r_m" : "n_h", json(shade.highlight)},
            {"ambient", json(shade.ambient)},
            {"diffuse", json(shade.diffuse)},
            {"specular", json(shade.specular)},
            {"sum", json(shade.sum)}};
}

Json json(const StoryStep& told, std::size_t number) {
    const auto& [step, name, checked] = told;
    Json row = {{"step", number}, {"name", name}, {"operation", word(step.operation)}};
    const int count = operands(step.operation);
    row["operands"] = count == 2   ? Json::array({step.left, step.right})
                      : count == 1 ? Json::array({step.left})
                                   : Json::array();
    row["file"] = source(step.file);
    row["line"] = step.line;
    row.update(json(checked));
    if (count > 0 && !is_comparison(step.operation)) {
        row["own_bits_lost"] = checked.own_loss;
        row["inherited_bits_lost"] = checked.inherited_loss;
    }
    return row;
}

Json json(const FirstHit& hit) {
    Json steps = Json::array();
    for (std::size_t i = 0; i < hit.steps.size(); ++i) steps.push_back(json(hit.steps[i], i));
    return {{"surface", hit.surface},
            {"t", json(hit.t)},
            {"t_by_exact_arithmetic", hit.t_by_exact},
            {"point", json(hit.point)},
            {"normal", json(hit.normal)},
            {"shading", hit.shade ? json(*hit.shade) : Json(nullptr)},
            {"most_bits_lost", hit.worst ? Json{{"step", *hit.worst}, {"bits", hit.worst_loss}} : Json(nullptr)},
            {"steps", std::move(steps)}};
}

}  // namespace

std::string to_json(const Story& story) {
    Json surfaces = Json::array();
    for (const Surface& surface : story.surfaces) surfaces.push_back(json(surface));
    const Options& options = story.options;
    const Json all = {
        {"version", version},
        {"command", story.command},
        {"title", story.title},
        {"size", {story.width, story.height}},
        {"pixel", {story.x, story.y}},
        {"column", story.column},
        {"row", story.row},
        {"line", verdict_line(story)},
        {"verdict", story.judgement ? Json(word(story.judgement->verdict)) : Json(nullptr)},
        {"truth", story.judgement ? json(*story.judgement) : Json(nullptr)},
        {"least_sure", story.judgement && story.judgement->least ? json(*story.judgement->least) : Json(nullptr)},
        {"shown", options.stage == 1 ? "ray"
                  : story.hit        ? "hit"
                                     : "miss"},
        {"surface", story.hit ? Json(story.hit->surface) : Json(nullptr)},
        {"color", json(story.color)},
        {"border", story.border},
        {"traced_color", json(story.traced)},
        {"options",
         {{"stage", options.stage},
          {"scalar", name_of(options.scalar)},
          {"steps_in", name_of(scalar_of_steps(options.scalar))},
          {"sphere", name_of(options.sphere_rule)},
          {"triangle", written(options.triangle_rule)}}},
        {"ray",
         {{"P", json(story.ray.P)},
          {"P_hex", hexes(story.ray.P)},
          {"D", json(story.ray.D)},
          {"D_hex", hexes(story.ray.D)}}},
        {"ray_color", story.ray_color ? json(*story.ray_color) : Json(nullptr)},
        {"in_all", story.in_all},
        {"tested", story.tested},
        {"nodes", json(story.nodes)},
        {"boxes_missed", json(story.boxes_missed)},
        {"met", story.met},
        {"surfaces", std::move(surfaces)},
        {"not_listed", story.not_listed},
        {"hit", story.hit ? json(*story.hit) : Json(nullptr)},
    };
    return all.dump(1, ' ', true, Json::error_handler_t::replace) + '\n';
}

}  // namespace glassbox
