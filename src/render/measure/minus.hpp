#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "render/measure/measurements.hpp"
#include "render/parameters.hpp"
#include "render/setup.hpp"

namespace glassbox {

/// Settings by which a measurement is made once more, to be subtracted from the one that is made without them.
struct Minus {
    Setup setup{};                         ///< what of it is told counts
    std::vector<const Parameter*> told{};  ///< in the order of the table

    bool operator==(const Minus&) const = default;
};

/// The setup with these settings changed.
Setup changed_by(const Minus& minus, Setup setup);

/// As it is typed: "scalar:certified,triangle:tolerance:10".
std::string written(const Minus& minus);

/// What these settings are in a setup, in words: "scalar float, triangle tolerance:10".
std::string told_of(const Minus& minus, const Setup& setup);

/// Why a difference of such measurements has no meaning; empty where it has one.
std::string why_no_difference(const Measurement& what);

/// The name of a measurement's difference, or of one component's, in files and legends:
/// "depth-minus-scalar:certified". Without commas, so that it fits into a table's header.
std::string difference_name(std::string_view what, const Minus& minus);

/// The same in the name of a file: "depth-minus-scalar-certified".
std::string difference_file_name(std::string_view what, const Minus& minus);

}  // namespace glassbox
