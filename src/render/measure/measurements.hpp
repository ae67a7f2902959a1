#pragma once
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace glassbox {

struct PixelNumbers;

/// How a measurement is coloured.
enum class Scale {
    sequential,  ///< from its least to its greatest value
    diverging,   ///< the same on both sides of 0
    direction,   ///< three components from -1 to 1, shown as red, green, blue
};

/// What tells a measurement its values.
enum class Source {
    ray,          ///< every ray has one
    hit,          ///< what the ray meets first
    light,        ///< the shading there
    half_vector,  ///< that of the shading
    spheres,      ///< the tests of spheres
    sides,        ///< the side products of triangles
    proof,        ///< a search that proves its answers
    true_t,       ///< a comparison with the t that a proof finds at the same surface
    boxes,        ///< the engine's walk
};

/// What it takes to measure something, beyond listening to what is traced anyway.
struct Needs {
    bool truth = false;      ///< what a certified search finds, to compare with
    bool triangles = false;  ///< what the side products of every triangle tested say about themselves
    bool drift = false;      ///< the view turned in another way, to compare with
    bool all_hits = false;   ///< what lies behind what is seen, too
    bool boxes = false;      ///< the engine's hierarchy
};

/// One thing that `glassbox measure` can measure.
struct Measurement {
    std::string_view name;         ///< as typed: "depth"
    std::string_view unit;         ///< "|D|"; empty for a pure number or a count
    std::string_view explanation;  ///< one line for a legend or a list
    Scale scale;
    Source source;
    std::optional<std::pair<double, double>> range;      ///< fixed range of its colours; otherwise that of its values
    std::span<const std::string_view> channels;          ///< the names of its components: itself, or x, y and z
    std::array<double, 3> (*read)(const PixelNumbers&);  ///< its components at a pixel, as many as it has channels
    Needs needs = {};
    std::optional<double> contour = {};  ///< a value whose border is drawn as a line
};

/// All measurements, in the order in which they are listed.
std::span<const Measurement> measurements();

/// The measurement of that name, or null.
const Measurement* find_measurement(std::string_view name);

}  // namespace glassbox
