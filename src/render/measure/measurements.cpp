#include "render/measure/measurements.hpp"

#include <algorithm>

#include "render/measure/pixel_numbers.hpp"

namespace glassbox {

namespace {

using P = PixelNumbers;
using T = TriangleNumbers;

constexpr std::string_view normal_names[] = {"normal.x", "normal.y", "normal.z"};

template <double P::*member>
std::array<double, 3> read(const P& numbers) {
    return {numbers.*member};
}

template <double T::*member>
std::array<double, 3> read(const P& numbers) {
    return {numbers.triangles.*member};
}

constexpr Measurement number(std::string_view name, std::string_view unit, std::string_view explanation, Scale scale,
                             Source source, std::array<double, 3> (*its_read)(const P&)) {
    return {name, unit, explanation, scale, source, {}, {}, its_read, {}, {}};
}

constexpr Measurement between(double low, double high, Measurement measurement) {
    measurement.range = {low, high};
    return measurement;
}

template <bool Needs::*what>
constexpr Measurement needing(Measurement measurement) {
    measurement.needs.*what = true;
    return measurement;
}

constexpr Measurement about_sides(OfSides what, Measurement measurement) {
    measurement.needs.sides = what;
    return measurement;
}

constexpr Measurement with_contour(double value, Measurement measurement) {
    measurement.contour = value;
    return measurement;
}

/// The same, of which these values are the worst.
template <Worst which, Alarm alarm = Alarm::none>
constexpr Measurement worst(Measurement measurement) {
    measurement.worst = which;
    measurement.alarm = alarm;
    return measurement;
}

constexpr Measurement spaced(Spacing spacing, Measurement measurement) {
    measurement.spacing = spacing;
    return measurement;
}

constexpr Measurement with_infinities(std::string_view minus, std::string_view plus, Measurement measurement) {
    measurement.minus_infinity = minus;
    measurement.infinity = plus;
    return measurement;
}

constexpr Measurement in_words(std::span<const std::string_view> words, Measurement measurement) {
    measurement.words = words;
    return measurement;
}

constexpr Scale sequential = Scale::sequential, diverging = Scale::diverging;

constexpr std::string_view verdicts[] = {"right", "wrong hit", "wrong miss", "wrong surface"};

constexpr Measurement all[] = {
    needing<&Needs::only_count>(number("tests", "", "how many surfaces were tested against the pixel's ray", sequential,
                                       Source::ray, read<&P::tests>)),
    needing<&Needs::all_hits>(number("hits", "", "how many surfaces the ray meets ahead of its start", sequential,
                                     Source::ray, read<&P::hits>)),
    number("depth", "|D|", "t of the nearest surface, in lengths of the ray's direction", sequential, Source::hit,
           read<&P::t>),
    Measurement{"normal",
                "",
                "the unit normal where the ray meets the nearest surface",
                Scale::direction,
                Source::hit,
                std::pair{-1.0, 1.0},
                normal_names,
                [](const P& numbers) { return numbers.normal; },
                {},
                {}},
    between(-1, 1,
            number("n.l", "", "n·l, the cosine of the angle between normal and light", diverging, Source::light,
                   read<&P::n_l>)),
    between(-1, 1,
            number("n.h", "", "n·h, the cosine of the angle between normal and half vector", diverging,
                   Source::half_vector, read<&P::n_h>)),
    between(-1, 1,
            number("n.r", "", "n·r, the cosine of the angle between normal and viewer", diverging, Source::light,
                   read<&P::n_r>)),
    number("ambient", "", "k_a, the ambient term before its colour", sequential, Source::light, read<&P::ambient>),
    number("diffuse", "", "I k_d max(0, n·l), the diffuse term before its colour", sequential, Source::light,
           read<&P::diffuse>),
    number("specular", "", "I k_s max(0, n·h)ᵉ, the specular term before its colour", sequential, Source::light,
           read<&P::specular>),
    spaced(Spacing::symlog, worst<Worst::nearest_0>(number(
                                "discriminant", "length² |D|²",
                                "(v·D)² − D²(v² − r²), the largest of all spheres: negative where every one is missed",
                                diverging, Source::spheres, read<&P::discriminant>))),
    worst<Worst::nearest_0>(about_sides(
        OfSides::least,
        number("side", "", "the smallest side product over the sum of its terms' sizes: 0 on an edge's line", diverging,
               Source::sides, read<&T::side>))),
    between(-4, 16,
            worst<Worst::least, Alarm::below_0>(about_sides(
                OfSides::least_certain,
                with_infinities(
                    "computed as 0, or too large: nothing is known", "exactly 0, and known to be",
                    number("margin", "digits",
                           "log10 of the deciding side product over its error bound: below 0 it decides nothing",
                           Scale::danger, Source::sides, read<&T::margin>))))),
    worst<Worst::greatest, Alarm::above_0>(
        number("undecided", "", "how many surfaces error bounds could not decide: exact arithmetic did", Scale::alarm,
               Source::proof, read<&P::undecided>)),
    between(0, 3,
            worst<Worst::greatest, Alarm::above_0>(needing<&Needs::truth>(
                in_words(verdicts, number("verdict", "", "0 right, 1 wrong hit, 2 wrong miss, 3 wrong surface",
                                          Scale::words, Source::ray, read<&P::verdict>))))),
    with_infinities(
        "a difference of 0: all signs agree", "",
        with_contour(
            1, about_sides(OfSides::all,
                           number("deficit", "log10",
                                  "the paper's difference | |a+b+c| − (|a|+|b|+|c|) |; the line is its tolerance of 10",
                                  sequential, Source::sides, read<&T::deficit>)))),
    needing<&Needs::truth>(number("bits-lost", "bits",
                                  "how many of the last bits of t are not the true ones: log2(ulps + 1)", Scale::danger,
                                  Source::true_t, read<&P::bits_lost>)),
    about_sides(OfSides::all,
                number("identity", "u P", "how far a+b+c is from −D·((B−A)×(C−A)), which it equals without rounding",
                       sequential, Source::sides, read<&T::identity>)),
    needing<&Needs::drift>(number("drift", "length",
                                  "how far the ray's start drifts when turns are added up step by step", sequential,
                                  Source::ray, read<&P::drift>)),
    needing<&Needs::boxes>(number("nodes", "", "how many nodes of the hierarchy of boxes the ray visited", sequential,
                                  Source::boxes, read<&P::nodes>)),
    needing<&Needs::boxes>(number("boxes-missed", "", "how many boxes of these nodes it missed, or had no need to open",
                                  sequential, Source::boxes, read<&P::boxes_missed>)),
};

}  // namespace

std::span<const Measurement> measurements() { return all; }

const Measurement* find_measurement(std::string_view name) {
    if (name == "n.v") name = "n.r";  // its name up to version 0.2
    const auto* const found =
        std::find_if(std::begin(all), std::end(all), [&](const Measurement& m) { return m.name == name; });
    return found == std::end(all) ? nullptr : found;
}

}  // namespace glassbox
