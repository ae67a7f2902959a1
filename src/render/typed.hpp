#pragma once
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/measure/measurements.hpp"
#include "render/measure/minus.hpp"
#include "render/parameters.hpp"
#include "render/pixel.hpp"
#include "scene/error.hpp"
#include "scene/named.hpp"
#include "scene/scene.hpp"
#include "scene/suggestion.hpp"

namespace glassbox {

inline constexpr NameTable<bool, 2> switches{{{"on", true, ""}, {"off", false, ""}}};

// Parses the words after an option of the command line, or after a script's command. Each function throws WrongWord for
// an invalid one, and says what would be right.

/// "--size: 'x' must be …": what is wrong with a word that was typed.
struct WrongWord : Error {
    using Error::Error;
};
WrongWord wrong(std::string_view option, const std::string& message);

/// A whole number from `least` to `most`.
int whole_number(std::string_view option, const std::string& typed, int least, int most);

/// A number from `least` to `most`.
double number(std::string_view option, const std::string& typed, double least, double most);

/// A finite number, 0 or more.
double factor(std::string_view option, const std::string& typed);

/// "X,Y,Z", a vector that has a direction.
Vec3<double> direction(std::string_view option, const std::string& typed);

/// "OX,OY,OZ,DX,DY,DZ", a ray that can be traced.
Ray<double> ray(std::string_view option, const std::string& typed);

/// Width and height: "800x600".
std::pair<int, int> size(std::string_view option, const std::string& typed);

/// "z:10,y:-20", in this order.
std::vector<Turn<double>> turns(std::string_view option, const std::string& typed);

/// "pluecker", "tolerance", "tolerance:0.5" or "moeller-trumbore".
TriangleRule triangle_rule(std::string_view option, const std::string& typed);

/// The same setup, with the parameter as it was typed after the option.
Setup with_typed(Setup setup, const Parameter& parameter, std::string_view option, const std::string& typed);

/// "X,Y", a pixel of the scene's picture.
Pixel pixel(std::string_view option, const std::string& typed, const Scene& scene);

/// The measurement of that name.
const Measurement& measurement(std::string_view option, const std::string& typed);

/// "scalar:certified,triangle:tolerance:10": other settings, each the name of an option and its value.
Minus minus(std::string_view option, const std::string& typed);

/// The words between commas, empty ones too.
std::vector<std::string> between_commas(const std::string& typed);

/// The value of the name that was typed.
template <class Value, std::size_t count>
Value chosen(std::string_view option, const std::string& typed, const NameTable<Value, count>& table) {
    if (const auto value = find_named(table, typed)) return *value;
    throw wrong(option, fmt::format("'{}' is not known; {}", typed, suggestion(typed, names(table))));
}

}  // namespace glassbox
