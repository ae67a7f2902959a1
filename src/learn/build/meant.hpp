#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "learn/build/first_error.hpp"

namespace glassbox::learn {

/// A function's declaration, as far as its text tells.
struct Declared {
    struct Parameter {
        std::string type, name;  ///< "Ray", without const, namespace and template arguments; "ray"
    };
    std::string returns;  ///< "Interval<Real>"
    std::vector<Parameter> parameters;
};

/// Returns the declaration of the function template around a line of a file, counted from 1.
Declared declared_above(std::string_view source, std::size_t line);

/// The length of the operand at the front of a text, such as "ray.D", "(a + b)" or "dot(a, b)". With `backwards`, that
/// of the operand at the end of the text.
std::size_t length_of_operand(std::string_view text, bool backwards);

/// The members of a struct, as the headers in the learner's folder or ours declare it; none if they do not.
std::vector<std::string> members_of(const std::string& name, const std::vector<std::filesystem::path>& folders);

/// Returns what the learner may have meant, and what to write, where the line of source tells more than the compiler's
/// message: P for ray.P, max for std::max, const v for const auto v; "" if we do not know. `folders` have the headers
/// that declare what is used.
std::string meant(const CompileError& error, const std::vector<std::filesystem::path>& folders);

/// What is said of a line that calls cos_sin with a Turn: the compiler complains of what follows from that. "" for any
/// other line.
std::string takes_degrees(std::string_view source, std::size_t line);

}  // namespace glassbox::learn
