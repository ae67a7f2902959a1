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

/// One thing that `glassbox measure` can measure.
struct Measurement {
    std::string_view name;         ///< as typed: "depth"
    std::string_view unit;         ///< "|D|"; empty for a pure number or a count
    std::string_view explanation;  ///< one line for a legend or a list
    Scale scale;
    std::optional<std::pair<double, double>> range;      ///< fixed range of its colours; otherwise that of its values
    std::span<const std::string_view> planes;            ///< the names of its components: itself, or x, y and z
    std::array<double, 3> (*read)(const PixelNumbers&);  ///< its components at a pixel, as many as it has planes
    bool needs_truth = false;                            ///< compared with what a certified search finds
    std::optional<double> contour = {};                  ///< a value whose border is drawn as a line
};

/// All measurements, in the order in which they are listed.
std::span<const Measurement> measurements();

/// The measurement of that name, or null.
const Measurement* find_measurement(std::string_view name);

}  // namespace glassbox
