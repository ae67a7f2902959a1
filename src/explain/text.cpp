#include "explain/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "explain/loss.hpp"
#include "explain/phrases.hpp"
#include "explain/scalar_of_steps.hpp"
#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "render/option_names.hpp"
#include "scene/printable.hpp"
#include "scene/shading_models.hpp"

namespace glassbox {

namespace {

using namespace story;

/// "2500 ± 3.1e-10"; "350 exact".
std::string bounded(const Number& n) {
    const auto [value, its_bound] = with_bound(n);
    return value + ' ' + its_bound;
}

constexpr std::size_t most_columns = 100;

std::size_t columns(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }));
}

/// The line that all else is about, in two if it is long.
std::string headline(const Story& story) {
    std::string line = fmt::format("{} {}\n", sign(mark_of(story)), verdict_line(story));
    const std::size_t rest = line.find("; ");
    if (columns(line) > most_columns && rest != std::string::npos) line.replace(rest + 1, 1, "\n  ");
    return line;
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

    /// The same in one line, joined by `between`, or in two if that is too long, the second one under the first.
    void line_or_two(std::string first, std::string_view between, const std::string& second, std::size_t indent) {
        const bool fits = second.empty() || 2 + columns(first) + columns(between) + columns(second) <= most_columns;
        if (fits) first.append(between).append(second);
        line("{}", first);
        if (!fits) line("{:<{}}{}", "", indent, second);
    }

    std::string take() && { return std::move(text_); }

private:
    std::string text_;
};

void tell_pixel(Page& page, const Story& story) {
    page.line("colour    {}, #{:02x}{:02x}{:02x}", triple(story.color), story.color.red, story.color.green,
              story.color.blue);
    if (story.border) page.line("          the border, painted over what the ray brings: {}", triple(story.traced));
    page.line("shown     {}", shown_phrase(story));
    if (story.in_all > 0) page.line("search    {}", counts(story) + (story.nodes ? ", " + boxes(story) : ""));
    if (story.judgement && story.judgement->least) {
        const LeastSure& least = *story.judgement->least;
        const std::string culprit = lost_by(least, story);
        page.line_or_two(fmt::format("margin    {}: {}", margin_in_words(least, story.options), whose(least, story)),
                         culprit.empty() ? "" : "; ", culprit, 10);
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
    page.heading(fmt::format("The surfaces  {} in all, {} met; ✓ as it truly is, ✗ not", story.in_all, story.met));
    for (const Surface& surface : story.surfaces) {
        const Mark mark = mark_of(surface, story);
        page.line("{:>5} {} {:<9}  {}{}", surface.number, sign(mark), word(surface.kind), why(surface, story),
                  surface.needed_exact ? "  (decided in exact arithmetic)" : "");
        if (mark == Mark::wrong) page.line("{:>18} {}", "", truth_of(surface, story));
    }
    if (story.not_listed > 0)
        page.line("and {} more, missed by more than these; --json tells the numbers of all that are listed",
                  story.not_listed);
}

void tell_roots(Page& page, std::string_view rule, const RootPair& roots) {
    const auto row = [&](std::string_view before, const char* name, const Number& n) {
        page.line("       {:<9} {} = {:<27} {} {}", before, name, bounded(n), sign(mark_of_sign(n)), sign_and_lost(n));
    };
    row(rule, "Δ ", roots.discriminant);
    if (roots.t0) row("", "t₀", *roots.t0);
    if (roots.t1) row("", "t₁", *roots.t1);
}

void tell_test(Page& page, std::size_t number, const SphereTest& test) {
    page.line("{:>5}  sphere about {}, radius {}", number, triple(test.center), short_number(test.radius));
    tell_roots(page, "textbook", test.textbook);
    tell_roots(page, "stable", test.stable);
}

void tell_test(Page& page, std::size_t number, const TriangleTest& test) {
    const auto& [A, B, C] = test.vertices;
    const auto row = [&](const std::string& before, char vertex, const Vec3<double>& v, char side, const Number& n) {
        const std::string corner = triple(v), value = bounded(n);
        const std::string truth = fmt::format("{} {}", sign(mark_of_sign(n)), sign_and_lost(n));
        constexpr std::size_t corner_width = 23, value_width = 29, others = 19;  // what stands between them
        const bool fits =
            std::max(columns(corner), corner_width) + std::max(columns(value), value_width) + columns(truth) + others <=
            most_columns;
        if (fits) return page.line("{:>5}  {} = {:<23} {} = {:<29} {}", before, vertex, corner, side, value, truth);
        page.line("{:>5}  {} = {}", before, vertex, corner);
        page.line("{:>5}  {} = {:<29} {}", "", side, value, truth);
    };
    row(std::to_string(number), 'A', A, 'a', test.a);
    row("", 'B', B, 'b', test.b);
    row("", 'C', C, 'c', test.c);
    page.line("       a+b+c = {}", bounded(test.sum));
    page.line("       | |a+b+c| − (|a|+|b|+|c|) | = {}, {}: the paper's rule says {}", short_number(test.deficit.value),
              tolerance_phrase(test), test.accepted ? "hit" : "miss");
}

/// If there are many surfaces, only those met are told in full.
bool is_told_in_full(const Surface& surface, const Story& story) {
    return story.not_listed == 0 || is_met(surface.fate);
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
        page.line("{} = {:<27} {}, {}", name, bounded(n), degrees(n.value), lost(n));
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

void tell_losses(Page& page, const FirstHit& hit) {
    page.heading(fmt::format("The rounding  {} operations", count_operations(hit)));
    if (!hit.worst) {
        page.line("none lost a bit: all are exact");
        return;
    }
    const auto& [step, name, checked] = hit.steps[*hit.worst];
    page.line("the most was lost by  {} = {}{}", operation(hit.steps, step), short_number(checked.value),
              name.empty() ? "" : fmt::format("  ({})", name));
    page.line("{:<21} {}, {}", "", own_and_inherited(checked), place(step));
    page.line("{:<21} truly {}, computed {}", "", truth(checked), with_minus(fmt::format("{:.17g}", checked.value)));
    constexpr std::size_t most_told = 4;
    const std::vector<StepNumber> worst = worst_losses(hit.steps, most_told);
    for (std::size_t i = 1; i < worst.size(); ++i) {
        const StoryStep& next = hit.steps[worst[i]];
        page.line_or_two(
            fmt::format("{:<21} {} = {}{}", i == 1 ? "then by" : "", operation(hit.steps, next.step),
                        short_number(next.checked.value), next.name.empty() ? "" : fmt::format("  ({})", next.name)),
            ": ", own_and_inherited(next.checked), 22);
    }
}

void tell_hit(Page& page, const Story& story, const FirstHit& hit) {
    page.heading(fmt::format("The hit  surface {}", hit.surface));
    page.line("t      = {:<27} {}{}", bounded(hit.t), lost(hit.t),
              hit.t_by_exact ? ", not by these steps: they have too few digits, or overflow" : "");
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
    std::string text = headline(story);
    text += fmt::format("Pixel ({}, {}) of {} × {}, column {} and row {} from the bottom left\n", story.x, story.y,
                        story.width, story.height, story.column, story.row);
    if (!story.title.empty()) text += "  " + printable(story.title) + '\n';
    Page page;
    tell_pixel(page, story);
    tell_ray(page, story);
    if (story.in_all > 0) tell_surfaces(page, story);
    tell_tests(page, story, true, "Spheres  t₀ and t₁: where the line enters and leaves; Δ < 0: it does neither");
    tell_tests(page, story, false,
               "Triangles  side products a, b, c, in length³: a hit where no two have opposite signs");
    if (story.hit) tell_hit(page, story, *story.hit);
    return text + std::move(page).take();
}

}  // namespace glassbox
