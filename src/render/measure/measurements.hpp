#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "render/measure/of_sides.hpp"
#include "render/measure/spacing.hpp"

namespace glassbox {

struct PixelNumbers;

/// How a measurement is coloured.
enum class Scale {
    sequential,  ///< from its least to its greatest value
    diverging,   ///< the same on both sides of 0
    difference,  ///< the same, and whatever is not 0 is told from 0 at sight
    direction,   ///< three components from -1 to 1, shown as red, green, blue
    danger,      ///< safe values are dark, the worst are bright
    alarm,       ///< 0 is dark, all above it bright
    words,       ///< a few words, each with a colour: right, and what can be wrong
};

/// Which of its values are the worst.
enum class Worst { greatest, least, nearest_0, farthest_from_0 };

/// Which of its values raise an alarm: something is wrong there, or not decided.
enum class Alarm { none, above_0, below_0 };

/// Where a measurement's values come from.
enum class Source {
    ray,          ///< every ray has one
    hit,          ///< what the ray meets first
    light,        ///< the shading at the hit
    half_vector,  ///< the shading's half vector
    spheres,      ///< the tests of spheres
    sides,        ///< the side products of triangles
    proof,        ///< a search that proves its answers
    true_t,       ///< a comparison with the true t at the same surface
    boxes,        ///< the engine's traversal
};

/// What a measurement needs beyond listening to the rays that are traced anyway.
struct Needs {
    bool truth = false;                ///< the true hits, to compare with
    bool drift = false;                ///< the view turned in the other way, to compare with
    bool all_hits = false;             ///< hits behind the nearest one, too
    bool boxes = false;                ///< the engine's hierarchy
    OfSides sides = OfSides::nothing;  ///< the side products of the tested triangles, measured
    bool only_count = false;           ///< nothing but how many surfaces are tested
};

/// One thing that `glassbox measure` can measure.
struct Measurement {
    std::string_view name;         ///< as typed on the command line: "depth"
    std::string_view unit;         ///< "|D|"; empty for a pure number or a count
    std::string_view explanation;  ///< one line for a legend or a list
    Scale scale;
    Source source;
    std::optional<std::pair<double, double>> range;      ///< fixed range of its colours; else that of its values
    std::span<const std::string_view> components;        ///< the names of x, y and z; empty for a single number
    std::array<double, 3> (*read)(const PixelNumbers&);  ///< its components at a pixel, as many as it has channels
    Needs needs = {};
    std::optional<double> contour = {};  ///< a value whose contour is drawn
    Worst worst = Worst::greatest;
    Alarm alarm = Alarm::none;
    Spacing spacing = Spacing::linear;             ///< unless the user chooses another
    std::span<const std::string_view> words = {};  ///< what 0, 1, … mean, if they are no numbers
    std::string_view minus_infinity = {};          ///< what −∞ means, if it says more than that
    std::string_view infinity = {};                ///< what ∞ means, likewise

    /// Whether that value raises its alarm. −∞ is below 0; NaN raises none.
    bool alarms(double value) const {
        return (alarm == Alarm::above_0 && value > 0) || (alarm == Alarm::below_0 && value < 0);
    }

    /// The names of its channels: that of a single number is its own.
    std::span<const std::string_view> channels() const { return components.empty() ? std::span(&name, 1) : components; }
};

/// All measurements, in the order in which they are listed.
std::span<const Measurement> measurements();

/// The measurement of that name, or null. `n.r` is also found by the name that it once had, `n.v`.
const Measurement* find_measurement(std::string_view name);

}  // namespace glassbox
