#include "viewer/model/story/inspector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "explain/phrases.hpp"
#include "explain/scalar_of_steps.hpp"
#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "render/option_names.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

using namespace story;
using Numbers = std::vector<InspectedNumber>;

/// As in explain's JSON, but 500 instead of 500.0, and with − for its hyphen.
std::string all_digits(double value) {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    std::string text = nlohmann::json(value).dump();
    if (text.ends_with(".0")) text.resize(text.size() - 2);
    return with_minus(std::move(text));
}

InspectedNumber plain(std::string path, double value) { return {std::move(path), value, {}, false}; }
InspectedNumber count(std::string path, double value) { return {std::move(path), value, {}, true}; }
InspectedNumber inspected(std::string path, const Number& number) {
    return {std::move(path), number.value, number, false};
}

Numbers plains(const std::string& path, std::initializer_list<double> values) {
    Numbers numbers;
    for (const double value : values) numbers.push_back(plain(fmt::format("{}/{}", path, numbers.size()), value));
    return numbers;
}
Numbers counts(const std::string& path, std::initializer_list<double> values) {
    Numbers numbers = plains(path, values);
    for (InspectedNumber& number : numbers) number.is_count = true;
    return numbers;
}
Numbers plains(const std::string& path, const Vec3<double>& v) { return plains(path, {v.x, v.y, v.z}); }

InspectorRow row(std::string label, Numbers numbers, std::string note = {}) {
    return {std::move(label), std::move(numbers), std::move(note)};
}

InspectorRow row(std::string label, const std::string& path, const Number& number, std::string note = {}) {
    return row(std::move(label), {inspected(path, number)}, std::move(note));
}

InspectorRow row(std::string label, const std::string& path, const Vector& v, std::string note = {}) {
    return row(std::move(label),
               {inspected(path + "/0", v.x), inspected(path + "/1", v.y), inspected(path + "/2", v.z)},
               std::move(note));
}

InspectorRow row(std::string label, const std::string& path, Rgb color, std::string note = {}) {
    InspectorRow result =
        row(std::move(label), counts(path, {1.0 * color.red, 1.0 * color.green, 1.0 * color.blue}), std::move(note));
    result.color = color;
    return result;
}

/// A number whose bound matters: with a bar, its true sign, and the bits that it lost.
InspectorRow barred(std::string label, const std::string& path, const Number& number, bool with_sign = true) {
    InspectorRow result = row(std::move(label), path, number, with_sign ? sign_and_lost(number) : lost(number));
    result.with_bar = true;
    if (with_sign) result.mark = mark_of_sign(number);
    return result;
}

InspectorPart part(std::string title, std::string note = {}) { return {std::move(title), std::move(note)}; }

InspectorPart pixel_part(const Story& story) {
    InspectorPart pixel = part("The pixel");
    const Options& options = story.options;
    pixel.rows.push_back(row("colour", "/color", story.color,
                             fmt::format("#{:02x}{:02x}{:02x}", story.color.red, story.color.green, story.color.blue)));
    pixel.rows.push_back(row("shown", Numbers{}, shown_phrase(story)));
    pixel.rows.push_back(row("pixel", counts("/pixel", {1.0 * story.x, 1.0 * story.y}), "from the top left"));
    pixel.rows.push_back(
        row("column, row", {count("/column", story.column), count("/row", story.row)}, "from the bottom left"));
    pixel.rows.push_back(row("picture", counts("/size", {1.0 * story.width, 1.0 * story.height}), "pixels"));
    pixel.rows.push_back(row("stage", {count("/options/stage", options.stage)},
                             fmt::format("{}, steps in {}; spheres: {}, triangles: {}", name_of(options.scalar),
                                         name_of(scalar_of_steps(options.scalar)), name_of(options.sphere_rule),
                                         written(options.triangle_rule))));
    return pixel;
}

Numbers counts_of(std::initializer_list<std::pair<const char*, std::optional<std::size_t>>> known) {
    Numbers numbers;
    for (const auto& [path, value] : known)
        if (value) numbers.push_back(count(path, static_cast<double>(*value)));
    return numbers;
}

InspectorPart truth_part(const Story& story) {
    InspectorPart truth = part("The truth", story.judgement ? std::string(word(story.judgement->verdict)) : "");
    truth.mark = mark_of(story);
    truth.rows.push_back(row("verdict", Numbers{}, verdict_line(story)));
    truth.rows.back().mark = mark_of(story);
    if (!story.judgement) return truth;
    const Judgement& judgement = *story.judgement;
    truth.rows.push_back(row("truly nearest", counts_of({{"/truth/surface", judgement.truth}}),
                             fmt::format("{}by a search that shares nothing with this one; proven {}",
                                         judgement.truth ? "" : "nothing is there, ",
                                         judgement.truth_needed_exact ? "in exact arithmetic" : "by error bounds")));
    const auto judged_otherwise = [&](const char* label, const char* path, std::size_t surfaces, const char* what) {
        truth.rows.push_back(row(label, {count(path, static_cast<double>(surfaces))},
                                 fmt::format("{} {}", surfaces == 1 ? "surface is" : "surfaces are", what)));
    };
    judged_otherwise("wrongly met", "/truth/wrongly_met", judgement.wrongly_met, "said to be met, and truly missed");
    judged_otherwise("wrongly missed", "/truth/wrongly_missed", judgement.wrongly_missed,
                     "said to be missed, and truly met");
    if (!judgement.least) return truth;
    const LeastSure& least = *judgement.least;
    const char* const decided = least.sureness > 1                         ? "to spare"
                                : is_decided_exactly(least, story.options) ? "by bounds alone; exact arithmetic decided"
                                                                           : "and undecided";
    truth.rows.push_back(row("least margin", {plain("/least_sure/margin", margin(least))},
                             fmt::format("digits {}: {}", decided, whose(least, story))));
    truth.rows.push_back(
        row("of surface",
            counts_of({{"/least_sure/surface", least.surface}, {"/least_sure/nearer_than", least.nearer_than}}),
            least.nearer_than ? "the two whose t are compared" : "the one whose number it is"));
    if (least.row)
        truth.rows.push_back(row("listed as", counts_of({{"/least_sure/row", least.row}}),
                                 "its place among the surfaces below, counted from 0"));
    if (least.step)
        truth.rows.push_back(
            row("made by step", counts_of({{"/least_sure/step", least.step}}), "of its surface's test"));
    if (least.worst)
        truth.rows.push_back(row("worst step", counts_of({{"/least_sure/worst_step", least.worst}}),
                                 "of those that lead to it, the one that lost the most bits itself"));
    truth.rows.push_back(
        row("bits it lost", {plain("/least_sure/worst_bits", least.worst_loss)}, lost_by(least, story)));
    return truth;
}

InspectorPart ray_part(const Story& story) {
    InspectorPart ray = part("The ray", "f(t) = P + tD");
    ray.rows.push_back(row("P", plains("/ray/P", story.ray.P), "where it starts"));
    ray.rows.push_back(row("D", plains("/ray/D", story.ray.D), "where it goes"));
    if (story.ray_color) ray.rows.push_back(row("as a colour", "/ray_color", *story.ray_color));
    ray.rows.push_back(row("brings", "/traced_color", story.traced,
                           story.border ? "the border is painted over it" : "after all that follows"));
    return ray;
}

void add_roots(InspectorPart& part, const std::string& path, const char* rule, const RootPair& roots) {
    part.rows.push_back(barred(fmt::format("Δ {}", rule), path + "/discriminant", roots.discriminant));
    if (roots.t0) part.rows.push_back(barred(fmt::format("t₀ {}", rule), path + "/t0", *roots.t0));
    if (roots.t1) part.rows.push_back(barred(fmt::format("t₁ {}", rule), path + "/t1", *roots.t1));
}

void add_test(InspectorPart& part, const std::string& path, const Surface&, const SphereTest& test) {
    part.drawing = Diagram::sphere;
    add_roots(part, path + "/textbook", "textbook", test.textbook);
    add_roots(part, path + "/stable", "stable", test.stable);
    part.rows.push_back(row("centre", plains(path + "/center", test.center)));
    part.rows.push_back(row("radius", {plain(path + "/radius", test.radius)}));
}

void add_weights(InspectorPart& part, const std::string& path, const TriangleTest& test) {
    if (!test.weights) return;
    const auto& [a, b, c] = *test.weights;
    part.rows.push_back(row("weight of A", path + "/weights/A", a, "a over the sum"));
    part.rows.push_back(row("weight of B", path + "/weights/B", b, "b over the sum"));
    part.rows.push_back(row("weight of C", path + "/weights/C", c, "c over the sum"));
}

void add_test(InspectorPart& part, const std::string& path, const Surface& surface, const TriangleTest& test) {
    part.drawing = Diagram::triangle;
    part.rows.push_back(barred("a", path + "/sides/a", test.a));
    part.rows.push_back(barred("b", path + "/sides/b", test.b));
    part.rows.push_back(barred("c", path + "/sides/c", test.c));
    part.rows.push_back(barred("a+b+c", path + "/sum", test.sum));
    part.rows.push_back(row("difference", path + "/deficit", test.deficit, "| |a+b+c| − (|a|+|b|+|c|) |"));
    part.rows.push_back(row("tolerance", {plain(path + "/tolerance", test.tolerance)}, "of the paper's rule"));
    InspectorRow says =
        row("it says", Numbers{},
            fmt::format("{}: the difference is {}", test.accepted ? "hit" : "miss", tolerance_phrase(test)));
    if (test.sum.value == 0) says.note = "miss: a+b+c is 0";
    else if (test.accepted != (test.deficit.value < test.tolerance)) says.note += ", but it lies behind the start";
    says.mark = test.accepted == surface.truly_met ? Mark::right : Mark::wrong;
    part.rows.push_back(std::move(says));
    add_weights(part, path, test);
    const auto& [A, B, C] = test.vertices;
    part.rows.push_back(row("A", plains(path + "/vertices/0", A)));
    part.rows.push_back(row("B", plains(path + "/vertices/1", B)));
    part.rows.push_back(row("C", plains(path + "/vertices/2", C)));
}

std::string path_of(std::size_t surface) { return fmt::format("/surfaces/{}", surface); }

InspectorPart surface_part(const Story& story, std::size_t i) {
    const Surface& surface = story.surfaces[i];
    const std::string path = path_of(i);
    InspectorPart result = part(fmt::format("{} {}", word(surface.kind), surface.number), why(surface, story));
    if (surface.needed_exact) result.note += "; decided in exact arithmetic";
    result.number = count(path + "/surface", static_cast<double>(surface.number));
    result.mark = mark_of(surface, story);
    result.note += "; " + truth_of(surface, story);
    result.color = surface.color;
    result.open = surface.fate == Fate::nearest;
    result.surface = i;
    std::visit([&](const auto& test) { add_test(result, path, surface, test); }, surface.test);
    if (surface.t) {
        result.rows.push_back(row("t", path + "/t", *surface.t));
        result.in_note = inspected(path + "/t", *surface.t);
    }
    result.rows.push_back(row("colour", path + "/color", surface.color));
    return result;
}

InspectorPart surfaces_part(const Story& story) {
    InspectorPart surfaces = part("The surfaces", counts(story));
    surfaces.rows.push_back(row("in all", {count("/in_all", static_cast<double>(story.in_all))}));
    surfaces.rows.push_back(
        row("tested", {count("/tested", static_cast<double>(story.tested))}, "on the way to what the ray meets first"));
    if (story.nodes)
        surfaces.rows.push_back(
            row("boxes", counts_of({{"/nodes", story.nodes}, {"/boxes_missed", story.boxes_missed}}), boxes(story)));
    surfaces.rows.push_back(row("met", {count("/met", static_cast<double>(story.met))}));
    surfaces.rows.push_back(row("not listed", {count("/not_listed", static_cast<double>(story.not_listed))},
                                story.not_listed > 0 ? "missed by more than these" : ""));
    for (std::size_t i = 0; i < story.surfaces.size(); ++i) surfaces.parts.push_back(surface_part(story, i));
    return surfaces;
}

InspectorPart hit_part(const Story& story, const FirstHit& hit) {
    InspectorPart result = part("The hit", fmt::format("surface {}", hit.surface));
    result.number = count("/hit/surface", static_cast<double>(hit.surface));
    InspectorRow t = barred("t", "/hit/t", hit.t, false);
    if (hit.t_by_exact) t.note += ", not by these steps: they have too few digits, or overflow";
    result.rows.push_back(std::move(t));
    result.rows.push_back(row("point", "/hit/point", hit.point, "P + tD"));
    for (std::size_t i = 0; i < story.surfaces.size(); ++i) {
        const auto* test = std::get_if<TriangleTest>(&story.surfaces[i].test);
        if (story.surfaces[i].number != hit.surface || !test || !test->weights) continue;
        result.drawing = Diagram::weights;
        result.surface = i;
        add_weights(result, path_of(i), *test);
    }
    result.rows.push_back(row("normal n", "/hit/normal", hit.normal, "of length 1"));
    return result;
}

InspectorPart term_part(const char* title, const std::string& path, const char* k_name, const char* factor_name,
                        const Term& term, bool cut) {
    InspectorPart result = part(title, fmt::format("{} × {} = {}", short_number(term.factor.value), triple(term.color),
                                                   cut ? triple(term.bytes) : triple(term.product)));
    result.open = false;
    result.color = term.bytes;
    result.in_note = plain(path + "/factor", term.factor.value);
    result.rows.push_back(row(k_name, {plain(path + "/k", term.k)}));
    result.rows.push_back(row("factor", path + "/factor", term.factor, factor_name));
    result.rows.push_back(row("× colour", plains(path + "/color", term.color)));
    result.rows.push_back(row("= product", path + "/product", term.product));
    result.rows.push_back(row("as bytes", path + "/bytes", term.bytes, "cut to whole numbers"));
    return result;
}

InspectorPart light_part(const Story& story, const Shade& shade) {
    const std::string path = "/hit/shading";
    const bool phong = shade.model == ShadingModel::phong;
    const bool cut = shade.model == ShadingModel::levental_2014;
    InspectorPart light = part("The light", fmt::format("shading by {}", name_of(shade.model)));
    light.drawing = Diagram::angles;
    const auto cosine = [&](const char* label, const char* name, const Number& number, const char* words) {
        InspectorRow result = barred(label, path + name, number, false);
        result.note = fmt::format("{}: {}, {}", words, degrees(number.value), result.note);
        light.rows.push_back(std::move(result));
    };
    cosine("n·l", "/n_l", shade.n_l, "normal · light");
    cosine("n·r", "/n_r", shade.n_r, "normal · viewer");
    cosine(phong ? "r·m" : "n·h", phong ? "/r_m" : "/n_h", shade.highlight,
           phong ? "viewer · mirrored light" : "normal · half vector");
    light.rows.push_back(row("L", path + "/L", shade.L, "towards the light, as given"));
    light.rows.push_back(row("l", path + "/l", shade.l, "the same, of length 1"));
    light.rows.push_back(row("r", path + "/r", shade.r, "towards the viewer, of length 1"));
    light.rows.push_back(row(phong ? "m" : "h", path + (phong ? "/reflection" : "/half_vector"), shade.h,
                             phong ? "the light mirrored, 2(n·l)n − l"
                             : cut ? "unit(L + r): L not of length 1, as in the paper's program"
                                   : "half way, unit(l + r)"));
    InspectorPart sum = part("The colour", "ambient + diffuse + specular");
    sum.drawing = Diagram::terms;
    sum.rows.push_back(row("I", {plain(path + "/intensity", shade.intensity)}, "the light's intensity"));
    sum.rows.push_back(row("e", {plain(path + "/exponent", shade.exponent)}, "of the highlight"));
    sum.parts.push_back(term_part("ambient", path + "/ambient", "k_a", "k_a", shade.ambient, cut));
    sum.parts.push_back(term_part("diffuse", path + "/diffuse", "k_d", "I · k_d · max(0, n·l)", shade.diffuse, cut));
    sum.parts.push_back(term_part("specular", path + "/specular", "k_s",
                                  phong ? "I · k_s · max(0, r·m)^e" : "I · k_s · max(0, n·h)^e", shade.specular, cut));
    sum.rows.push_back(
        row("sum", path + "/sum", shade.sum, cut ? "not used: this model adds the bytes" : "rounded, at most 255"));
    sum.rows.push_back(row("pixel", "/traced_color", story.traced, cut ? "the sum of the bytes, at most 255" : ""));
    light.parts.push_back(std::move(sum));
    return light;
}

InspectorPart rounding_part(const Story& story, const FirstHit& hit) {
    InspectorPart rounding = part("The rounding", fmt::format("{} operations", count_operations(hit)));
    if (!hit.worst) {
        rounding.note += ": none lost a bit, all are exact";
        return rounding;
    }
    const auto& [step, name, checked] = hit.steps[*hit.worst];
    rounding.drawing = Diagram::bits;
    rounding.rows.push_back(row("worst", Numbers{}, operation(hit.steps, step)));
    rounding.rows.push_back(row("where", Numbers{}, place(step)));
    rounding.rows.push_back(row("step", {count("/hit/most_bits_lost/step", *hit.worst)}, name));
    rounding.rows.push_back(row("its own loss", {plain("/hit/most_bits_lost/bits", hit.worst_loss)},
                                fmt::format("bits, of {} that {} has", digits_of_steps(story.options),
                                            name_of(scalar_of_steps(story.options.scalar)))));
    rounding.rows.push_back(
        row("inherited", {plain(fmt::format("/hit/steps/{}/inherited_bits_lost", *hit.worst), checked.inherited_loss)},
            "bits, from operands off by more than a rounding"));
    rounding.rows.push_back(barred("computed", fmt::format("/hit/steps/{}", *hit.worst), checked));
    rounding.rows.push_back(
        row("truly", {plain(fmt::format("/hit/steps/{}/true", *hit.worst), checked.truth)}, "rounded once"));
    return rounding;
}

}  // namespace

std::vector<InspectorPart> inspector(const Story& story) {
    std::vector<InspectorPart> parts{pixel_part(story), truth_part(story), ray_part(story)};
    if (story.in_all > 0) parts.push_back(surfaces_part(story));
    if (!story.hit) return parts;
    parts.push_back(hit_part(story, *story.hit));
    if (story.hit->shade) parts.push_back(light_part(story, *story.hit->shade));
    else parts.back().rows.push_back(row("colour", Numbers{}, "before stage 4: the surface's own"));
    parts.push_back(rounding_part(story, *story.hit));
    return parts;
}

std::string written(const InspectedNumber& number, NumberForm form) {
    if (number.is_count) return all_digits(number.value);
    switch (form) {
        case NumberForm::brief:
            return std::isfinite(number.value) ? short_number(number.value) : all_digits(number.value);
        case NumberForm::full:
            return all_digits(number.value);
        case NumberForm::hex:
            return number.checked ? hex(number.checked->recorded) : hex(number.value);
    }
    return "";
}

WithBound written_with_bound(const InspectedNumber& number, NumberForm form) {
    std::string value = written(number, form);
    if (!number.checked) return {std::move(value), ""};
    const Number& n = *number.checked;
    constexpr int all_its_digits = 17;
    if (form == NumberForm::full || !std::isfinite(n.value)) return {value, bound(value, n, all_its_digits)};
    if (form == NumberForm::brief) return with_bound(n);
    // Hexadecimal digits are the double itself.
    return {std::move(value), n.error == 0 ? "exact" : std::isfinite(n.error) ? "± " + hex(n.error) : "± unknown"};
}

std::string note(const InspectorPart& part, NumberForm form) {
    if (!part.in_note || form == NumberForm::brief) return part.note;
    const std::string brief = written_with_bound(*part.in_note, NumberForm::brief).value;
    std::string text = part.note;
    if (const std::size_t at = text.find(brief); at != std::string::npos)
        text.replace(at, brief.size(), written(*part.in_note, form));
    return text;
}

std::string differences(const InspectorRow& first, const InspectorRow& second) {
    if (first.numbers.size() != second.numbers.size()) return {};
    std::string text;
    bool differ = false;
    for (std::size_t i = 0; i < first.numbers.size(); ++i) {
        const double difference = second.numbers[i].value - first.numbers[i].value;
        if (!std::isfinite(difference)) return {};
        differ = differ || difference != 0;
        text += fmt::format("{}{}{}", i == 0 ? "" : ", ", difference > 0 ? "+" : "", short_number(difference));
    }
    return differ ? text : std::string();
}

std::vector<NumberFact> facts(const InspectedNumber& number) {
    const std::string& path = number.path;
    if (number.is_count) return {{path, "value", written(number, NumberForm::full)}};
    if (!number.checked)
        return {{path, "value", written(number, NumberForm::full)}, {"", "in hex", written(number, NumberForm::hex)}};
    const Number& n = *number.checked;
    return {
        {path + "/value", "value", all_digits(n.value)},
        {path + "/hex", "in hex", hex(n.recorded)},
        {path + "/error", "off by at most", all_digits(n.error)},
        {path + "/true", "the truth", all_digits(n.truth)},
        {path + "/true_hex", "in hex", hex(n.truth)},
        {path + "/off", "off by", all_digits(n.distance)},
        {path + "/bits_lost", "bits lost", all_digits(n.bits_lost)},
        {path + "/sign", "true sign", std::to_string(n.sign)},
        {path + "/known", "the truth is known", std::string(word(n.known))},
    };
}

int digits_of_steps(const Options& options) {
    return with_scalar_of_steps(options.scalar,
                                []<class Real>(std::type_identity<Real>) { return std::numeric_limits<Real>::digits; });
}

}  // namespace glassbox
