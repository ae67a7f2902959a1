#include "render/measurements.hpp"

#include <algorithm>

#include "render/pixel_numbers.hpp"

namespace glassbox {

namespace {

using Names = std::array<std::string_view, 1>;

/// A measurement of one component: the member of PixelNumbers that keeps it.
template <double PixelNumbers::*member, const Names& name>
constexpr Measurement number(std::string_view unit, std::string_view explanation, Scale scale,
                             std::optional<std::pair<double, double>> range = {}) {
    return {name[0], unit, explanation, scale, range, name, [](const PixelNumbers& numbers) {
                return std::array<double, 3>{numbers.*member, 0, 0};
            }};
}

constexpr Names tests{"tests"}, hits{"hits"}, depth{"depth"}, n_l{"n.l"}, n_h{"n.h"}, n_v{"n.v"}, ambient{"ambient"},
    diffuse{"diffuse"}, specular{"specular"}, discriminant{"discriminant"}, side{"side"};
constexpr std::array<std::string_view, 3> normal{"normal.x", "normal.y", "normal.z"};

using P = PixelNumbers;
constexpr std::pair<double, double> cosine{-1, 1};

constexpr std::array<Measurement, 12> all{
    number<&P::tests, tests>("", "how many surfaces were tested against the pixel's ray", Scale::sequential),
    number<&P::hits, hits>("", "how many surfaces the ray meets ahead of its start", Scale::sequential),
    number<&P::t, depth>("|D|", "t of the nearest surface, in lengths of the ray's direction", Scale::sequential),
    Measurement{"normal", "", "the unit normal where the ray meets the nearest surface", Scale::direction, cosine,
                normal, [](const P& numbers) { return numbers.normal; }},
    number<&P::n_l, n_l>("", "n·l, the cosine of the angle between normal and light", Scale::diverging, cosine),
    number<&P::n_h, n_h>("", "n·h, the cosine of the angle between normal and half vector", Scale::diverging, cosine),
    number<&P::n_v, n_v>("", "n·r, the cosine of the angle between normal and viewer", Scale::diverging, cosine),
    number<&P::ambient, ambient>("", "k_a, the ambient term before its colour", Scale::sequential),
    number<&P::diffuse, diffuse>("", "I k_d max(0, n·l), the diffuse term before its colour", Scale::sequential),
    number<&P::specular, specular>("", "I k_s max(0, n·h)ᵉ, the specular term before its colour", Scale::sequential),
    number<&P::discriminant, discriminant>(
        "length² |D|²", "(v·D)² − D²(v² − r²), the largest of all spheres: negative where every one is missed",
        Scale::diverging),
    number<&P::side, side>("", "the smallest side product over the sum of its terms' sizes: 0 on an edge's line",
                           Scale::diverging),
};

}  // namespace

std::span<const Measurement> measurements() { return all; }

const Measurement* find_measurement(std::string_view name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) { return m.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace glassbox
