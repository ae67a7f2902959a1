#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/model/story/sources.hpp"

namespace glassbox {

/// A function that a header of the core defines.
struct SourceFunction {
    std::string name;                 ///< "dot", "operator-"; of a rule's operator(), its struct: "Stable"
    bool is_unary = false;            ///< it has one parameter
    std::size_t first = 0, last = 0;  ///< its lines, from 1: that of its name, that of its closing brace
    std::size_t body = 0;             ///< that of its opening brace
};

/// Returns the functions of a header, read from its text.
std::vector<SourceFunction> functions_of(const SourceFile& file);

/// Returns the one line of a function's body on which an operator stands, unary or with two operands; 0 if it stands on
/// several, or on none.
std::size_t only_line_with(const SourceFile& file, const SourceFunction& function, std::string_view sign,
                           bool is_unary);

}  // namespace glassbox
