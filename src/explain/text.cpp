#include "explain/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "explain/scalar_of_steps.hpp"
#include "explain/words.hpp"
#include "render/option_names.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

using namespace story;

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string triple(const Vec3<double>& v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }
std::string triple(const Vector& v) { return triple(Vec3<double>{v.x.value, v.y.value, v.z.value}); }
std::string triple(Rgb c) { return fmt::format("({}, {}, {})", c.red, c.green, c.blue); }

std::string bound(double error) {
    if (error == 0) return "exact";
    return std::isfinite(error) ? fmt::format("± {:.1e}", error) : "± unknown";
}

/// "2500 ± 3.1e-10"; "350 exact".
std::string bounded(const Number& n) { return short_number(n.value) + ' ' + bound(n.error); }

std::string lost(double bits) { return bits == 0 ? "no bits lost" : fmt::format("{:.1f} bits lost", bits); }

std::string_view sign(const Number& n) {
    if (n.known == Known::not_at_all) return "unknown";
    return n.sign > 0 ? "> 0" : n.sign < 0 ? "< 0" : "= 0";
}

/// "three side products of both signs".
std::string why(const Surface& surface, const Story& story) {
    const auto t = [&] { return surface.t ? fmt::format("t = {}", short_number(surface.t->value)) : std::string(); };
    switch (surface.fate) {
        case Fate::nearest:
            return fmt::format("met, nearest: {}", t());
        case Fate::farther:
            return fmt::format("met, but farther than surface {}: {}", story.hit ? story.hit->surface : 0, t());
        case Fate::apart:
            return "missed: Δ < 0, the line passes the sphere";
        case Fate::outside:
            return "missed: side products of both signs, the line passes outside";
        case Fate::edge_on:
            return "missed: all side products are 0, it is seen edge-on or has no area";
        case Fate::behind:
            return fmt::format("missed: behind the start, {} is not > 0", t());
        case Fate::overflow:
            return "missed: a number that decides has grown too large for the scalar";
        case Fate::beyond_tolerance:
            return "missed: the difference is not under the tolerance";
        case Fate::refused:
            return "missed: the rule that was chosen says no";
    }
    return "";
}

/// Writes lines, each section under its heading.
class Page {
public:
    void heading(std::string_view title) { fmt::format_to(std::back_inserter(text_), "\n{}\n", title); }

    template <class... Values>
    void line(fmt::format_string<Values...> format, Values&&... values) {
        text_ += "  ";
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
        while (text_.back() == ' ') text_.pop_back();
        text_ += '\n';
    }

    std::string take() && { return std::move(text_); }

private:
    std::string text_;
};

void tell_pixel(Page& page, const Story& story) {
    page.line("colour    {}, #{:02x}{:02x}{:02x}", triple(story.color), story.color.red, story.color.green,
              story.color.blue);
    if (story.border) page.line("          the border, painted over what the ray brings: {}", triple(story.traced));
    if (story.options.stage == 1) page.line("verdict   stage 1 knows no surfaces: the colour is the ray's direction");
    else if (!story.hit) page.line("verdict   nothing is met: the background");
    else {
        const std::size_t number = story.hit->surface;
        const auto row = std::find_if(story.surfaces.begin(), story.surfaces.end(),
                                      [&](const Surface& s) { return s.number == number; });
        const std::string what = row == story.surfaces.end()
                                     ? std::string("surface")
                                     : fmt::format("{} of colour {}, surface", word(row->kind), triple(row->color));
        page.line("verdict   {} {}, at t = {}", what, number, short_number(story.hit->t.value));
    }
    const Options& options = story.options;
    page.line("computed  {}, steps in {}, spheres: {}, triangles: {}, stage {}", name_of(options.scalar),
              name_of(scalar_of_steps(options.scalar)), name_of(options.sphere_rule), written(options.triangle_rule),
              options.stage);
    if (!story.command.empty()) page.line("again     {}", story.command);
}

void tell_ray(Page& page, const Story& story) {
    page.heading("The ray  f(t) = P + tD");
    const auto row = [&](char name, const Vec3<double>& v) {
        page.line("{} = {}", name, triple(v));
        page.line("    {:a}  {:a}  {:a}", v.x, v.y, v.z);
    };
    row('P', story.ray.P);
    row('D', story.ray.D);
    if (story.ray_color) page.line("as a colour {}", triple(*story.ray_color));
}

void tell_surfaces(Page& page, const Story& story) {
    page.heading(fmt::format("The surfaces  {} tested, {} met", story.tested, story.met));
    for (const Surface& surface : story.surfaces)
        page.line("{:>5}  {:<9}  {}{}", surface.number, word(surface.kind), why(surface, story),
                  surface.needed_exact ? "  (decided in exact arithmetic)" : "");
    if (story.not_listed > 0)
        page.line("and {} more, missed by more than these; --json tells the numbers of all that are listed",
                  story.not_listed);
}

void tell_roots(Page& page, std::string_view rule, const RootPair& roots) {
    page.line("       {:<9} Δ  = {:<27} truly {}, {}", rule, bounded(roots.discriminant), sign(roots.discriminant),
              lost(roots.discriminant.bits_lost));
    if (roots.t0) page.line("       {:<9} t₀ = {:<27} {}", "", bounded(*roots.t0), lost(roots.t0->bits_lost));
    if (roots.t1) page.line("       {:<9} t₁ = {:<27} {}", "", bounded(*roots.t1), lost(roots.t1->bits_lost));
}

void tell_test(Page& page, std::size_t number, const SphereTest& test) {
    page.line("{:>5}  sphere about {}, radius {}", number, triple(test.center), short_number(test.radius));
    tell_roots(page, "textbook", test.textbook);
    tell_roots(page, "stable", test.stable);
}

void tell_test(Page& page, std::size_t number, const TriangleTest& test) {
    const auto& [A, B, C] = test.vertices;
    const auto row = [&](const std::string& before, char vertex, const Vec3<double>& v, char side, const Number& n) {
        page.line("{:>5}  {} = {:<30} {} = {:<22} truly {}, {}", before, vertex, triple(v), side, bounded(n), sign(n),
                  lost(n.bits_lost));
    };
    row(std::to_string(number), 'A', A, 'a', test.a);
    row("", 'B', B, 'b', test.b);
    row("", 'C', C, 'c', test.c);
    page.line("       a+b+c = {}", bounded(test.sum));
    const char* const compared = test.sum.value == 0                   ? "but a+b+c is 0"
                                 : test.deficit.value < test.tolerance ? "under"
                                                                       : "not under";
    page.line("       | |a+b+c| − (|a|+|b|+|c|) | = {}, {}{}: the paper's rule says {}",
              short_number(test.deficit.value), compared, test.sum.value == 0 ? "" : ' ' + short_number(test.tolerance),
              test.accepted ? "hit" : "miss");
}

/// Of many surfaces only those met are told in full.
bool is_told_in_full(const Surface& surface, const Story& story) {
    return story.not_listed == 0 || surface.fate == Fate::nearest || surface.fate == Fate::farther;
}

bool is_sphere(const Surface& surface) { return std::holds_alternative<SphereTest>(surface.test); }

void tell_tests(Page& page, const Story& story, bool spheres, std::string_view title) {
    bool begun = false;
    for (const Surface& surface : story.surfaces) {
        if (is_sphere(surface) != spheres || !is_told_in_full(surface, story)) continue;
        if (!begun) page.heading(title);
        begun = true;
        std::visit([&](const auto& test) { tell_test(page, surface.number, test); }, surface.test);
    }
}

void tell_term(Page& page, std::string_view name, const Term& term, bool cut) {
    page.line("{:<9} {:<7} {:<12} {:<16} {:<32} {}", name, short_number(term.k), short_number(term.factor.value),
              triple(term.color), triple(term.product), cut ? triple(term.bytes) : "");
}

void tell_shade(Page& page, const Story& story, const Shade& shade) {
    const bool phong = shade.model == ShadingModel::phong;
    const bool cut = shade.model == ShadingModel::levental_2014;
    page.heading(fmt::format("The light  {}, I = {}, e = {}", name_of(shade.model), short_number(shade.intensity),
                             short_number(shade.exponent)));
    page.line("l = {}  towards the light, of length 1", triple(shade.l));
    page.line("r = {}  towards the viewer, of length 1", triple(shade.r));
    page.line("{} = {}  {}", phong ? 'm' : 'h', triple(shade.h),
              phong ? "the light mirrored, 2(n·l)n − l"
              : cut ? "unit(L + r), L not of length 1 as in the paper's program"
                    : "half way, unit(l + r)");
    const auto cosine = [&](std::string_view name, const Number& n) {
        page.line("{} = {:<27} {}", name, bounded(n), lost(n.bits_lost));
    };
    cosine("n·l", shade.n_l);
    cosine("n·r", shade.n_r);
    cosine(phong ? "r·m" : "n·h", shade.highlight);
    page.line("");
    page.line("{:<9} {:<7} {:<12} {:<16} {:<32} {}", "term", "k", "factor", "× colour", "= red, green, blue",
              cut ? "cut to bytes" : "");
    tell_term(page, "ambient", shade.ambient, cut);
    tell_term(page, "diffuse", shade.diffuse, cut);
    tell_term(page, "specular", shade.specular, cut);
    page.line("{:<47} {:<32} {}", cut ? "sum of the bytes, at most 255" : "sum, rounded, at most 255",
              cut ? "" : triple(shade.sum), triple(story.traced));
}

std::string operation(const FirstHit& hit, const Step& step) {
    const auto value = [&](StepNumber number) { return short_number(hit.steps[number].checked.value); };
    if (operands(step.operation) == 1) return fmt::format("{} {}", word(step.operation), value(step.left));
    return fmt::format("{} {} {}", value(step.left), word(step.operation), value(step.right));
}

void tell_losses(Page& page, const FirstHit& hit) {
    const auto count = std::count_if(hit.steps.begin(), hit.steps.end(),
                                     [](const StoryStep& s) { return operands(s.step.operation) > 0; });
    page.heading(fmt::format("The rounding  {} operations", count));
    if (!hit.worst) {
        page.line("none lost a bit: all are exact");
        return;
    }
    const auto& [step, name, checked] = hit.steps[*hit.worst];
    page.line("the most was lost by  {} = {}{}", operation(hit, step), short_number(checked.value),
              name.empty() ? "" : fmt::format("  ({})", name));
    const std::string place = step.operation == Operation::round
                                  ? "when the scene's number was rounded to the scalar"
                                  : fmt::format("at {}:{}", source(step.file), step.line);
    page.line("{:<21} {:.1f} bits, {}", "", hit.worst_loss, place);
    page.line("{:<21} truly {:.17g}, computed {:.17g}", "", checked.truth, checked.value);
}

void tell_hit(Page& page, const Story& story, const FirstHit& hit) {
    page.heading(fmt::format("The hit  surface {}", hit.surface));
    page.line("t      = {:<27} {}{}", bounded(hit.t), lost(hit.t.bits_lost),
              hit.t_by_exact ? ", found in exact arithmetic" : "");
    page.line("point  = {}", triple(hit.point));
    page.line("normal = {}", triple(hit.normal));
    for (const Surface& surface : story.surfaces) {
        const auto* test = std::get_if<TriangleTest>(&surface.test);
        if (surface.number != hit.surface || !test || !test->weights) continue;
        const auto& [a, b, c] = *test->weights;
        page.line("weights  A: {}  B: {}  C: {}  (the side products over their sum)", short_number(a.value),
                  short_number(b.value), short_number(c.value));
    }
    if (hit.shade) tell_shade(page, story, *hit.shade);
    else page.line("stage {} paints the surface's own colour", story.options.stage);
    tell_losses(page, hit);
}

}  // namespace

std::string to_text(const Story& story) {
    std::string text = fmt::format("Pixel ({}, {}) of {} × {}, column {} and row {} from the bottom left\n", story.x,
                                   story.y, story.width, story.height, story.column, story.row);
    if (!story.title.empty()) text += "  " + story.title + '\n';
    Page page;
    tell_pixel(page, story);
    tell_ray(page, story);
    if (story.tested > 0) tell_surfaces(page, story);
    tell_tests(page, story, true, "Spheres  t₀ and t₁: where the line enters and leaves; Δ < 0: it does neither");
    tell_tests(page, story, false,
               "Triangles  side products a, b, c, in length³: a hit where no two have opposite signs");
    if (story.hit) tell_hit(page, story, *story.hit);
    return text + std::move(page).take();
}

}  // namespace glassbox
