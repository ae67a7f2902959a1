#include "explain/phrases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "explain/verdict_phrases.hpp"
#include "explain/words.hpp"
#include "numerics/dyadic.hpp"
#include "numerics/printed_bound.hpp"

namespace glassbox {

using namespace story;

namespace {

constexpr int short_digits = 6;

std::string in_digits(double value, int digits) { return with_minus(fmt::format("{:.{}g}", value, digits)); }

/// As programs write it.
std::string with_hyphen(std::string_view number) {
    constexpr std::string_view minus = "−";
    return number.starts_with(minus) ? '-' + std::string(number.substr(minus.size())) : std::string(number);
}

}  // namespace

std::string with_minus(std::string number) {
    if (number.starts_with('-')) number.replace(0, 1, "−");
    return number;
}

std::string short_number(double value) { return in_digits(value, short_digits); }

std::string triple(const Vec3<double>& v) {
    return fmt::format("({}, {}, {})", short_number(v.x), short_number(v.y), short_number(v.z));
}
std::string triple(const Vector& v) { return triple(Vec3<double>{v.x.value, v.y.value, v.z.value}); }
std::string triple(Rgb c) { return fmt::format("({}, {}, {})", c.red, c.green, c.blue); }

std::string hex(double value) { return fmt::format("{:a}", value); }

std::string hex(long double value) {
    const auto rounded = static_cast<double>(value);
    return rounded < value || rounded > value ? fmt::format("{:a}", value) : hex(rounded);
}

namespace {

bool has_bound(const Number& n) { return std::isfinite(n.value) && std::isfinite(n.error); }

}  // namespace

WithBound with_bound(const Number& n) {
    std::string value = has_bound(n) ? with_minus(value_beside(n.value, n.error)) : short_number(n.value);
    std::string its_bound = bound(value, n);
    return {std::move(value), std::move(its_bound)};
}

std::string bound(std::string_view printed, const Number& n, int digits) {
    if (!has_bound(n)) return "± unknown";
    const std::string number = with_hyphen(printed), error = bound_beside(number, n.value, n.error, digits);
    if (error == "0") return "exact";
    return n.error == 0 && is_shortest(number, n.value) ? "exact as a double" : "± " + error;
}

std::string truth(const Number& n) {
    if (n.known == Known::not_at_all) return "unknown";
    return may_be_zero(n) ? fmt::format("0, as far as {} bits tell", Dyadic::long_bits)
                          : with_minus(fmt::format("{:.17g}", n.truth));
}

std::string lost(const Number& n) {
    if (std::isnan(n.bits_lost)) return "truly " + truth(n);
    return n.bits_lost == 0 ? "no bits lost" : fmt::format("{:.1f} bits lost", n.bits_lost);
}

std::string sign_and_lost(const Number& n) {
    if (std::isnan(n.bits_lost)) return lost(n);
    return fmt::format("{}truly {}, {}", mark_of_sign(n) == Mark::wrong ? "wrong: " : "",
                       n.sign > 0   ? "> 0"
                       : n.sign < 0 ? "< 0"
                                    : "= 0",
                       lost(n));
}

std::string own_and_inherited(const Number& n) {
    if (std::isnan(n.own_loss) || std::isnan(n.inherited_loss)) return "its own loss is not known";
    const auto bits = [](double loss) { return loss == 0 ? std::string("none") : fmt::format("{:.1f} bits", loss); };
    return fmt::format(
        "{} of its own, {} inherited", bits(n.own_loss),
        n.own_loss == 0 || n.inherited_loss == 0 ? bits(n.inherited_loss) : fmt::format("{:.1f}", n.inherited_loss));
}

std::string why(const Surface& surface, const Story& story) {
    const auto t = [&] { return surface.t ? fmt::format("t = {}", short_number(surface.t->value)) : std::string(); };
    const std::size_t hit = story.hit ? story.hit->surface : 0;
    switch (surface.fate) {
        case Fate::nearest:
            return fmt::format("met, nearest: {}", t());
        case Fate::as_near:
            return fmt::format("met, as near as surface {}, which is listed later and so is seen: {}", hit, t());
        case Fate::farther:
            return fmt::format("met, but farther than surface {}: {}", hit, t());
        case Fate::apart:
            return "missed: Δ < 0, the line passes the sphere";
        case Fate::touched:
            return "missed: Δ = 0, a touch, no hit by levental-2014";
        case Fate::from_inside:
            return fmt::format("missed: its nearer root lies behind, {}", t());
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

std::string shown_phrase(const Story& story) {
    if (story.options.stage == 1) return "stage 1 knows no surfaces: the colour is the ray's direction";
    if (!story.hit) return "nothing is met: the background";
    const std::size_t number = story.hit->surface;
    const auto row = std::find_if(story.surfaces.begin(), story.surfaces.end(),
                                  [&](const Surface& s) { return s.number == number; });
    const std::string what = row == story.surfaces.end()
                                 ? std::string("surface")
                                 : fmt::format("{} of colour {}, surface", word(row->kind), triple(row->color));
    return fmt::format("{} {}, at t = {}", what, number, short_number(story.hit->t.value));
}

double angle(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }

std::string degrees(double cosine) {
    return std::isfinite(cosine) ? fmt::format("{:.1f}°", angle(cosine)) : std::string("no angle");
}

std::string tolerance_phrase(const TriangleTest& test) {
    if (test.sum.value == 0) return "but a+b+c is 0";
    return fmt::format("{} {}", test.deficit.value < test.tolerance ? "under" : "not under",
                       short_number(test.tolerance));
}

namespace {

/// How many digits tell the sizes of two numbers apart, but at least six.
int digits_apart(double one, double other) {
    constexpr int all = 17;
    const double a = std::abs(one), b = std::abs(other);
    if (!(a < b || b < a)) return short_digits;
    int digits = short_digits;
    while (digits < all && in_digits(a, digits) == in_digits(b, digits)) ++digits;
    return digits;
}

}  // namespace

std::string operation(std::span<const StoryStep> steps, const Step& step) {
    const double left = steps[step.left].checked.value;
    if (operands(step.operation) == 1) return fmt::format("{} {}", word(step.operation), short_number(left));
    const double right = steps[step.right].checked.value;
    const bool differ_little =
        step.operation == Operation::add || step.operation == Operation::subtract || is_comparison(step.operation);
    const int digits = differ_little ? digits_apart(left, right) : short_digits;
    return fmt::format("{} {} {}", in_digits(left, digits), word(step.operation), in_digits(right, digits));
}

std::string place(const Step& step) {
    return step.operation == Operation::round ? "when the scene's number was rounded to the scalar"
                                              : fmt::format("at {}:{}", source(step.file), step.line);
}

std::size_t count_operations(const FirstHit& hit) {
    return static_cast<std::size_t>(std::count_if(hit.steps.begin(), hit.steps.end(),
                                                  [](const StoryStep& s) { return operands(s.step.operation) > 0; }));
}

}  // namespace glassbox
