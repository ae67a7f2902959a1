#pragma once
#include <cstddef>
#include <string_view>

namespace glassbox::learn {

/// Returns the line, counted from 1, in which a function of an exercise begins in the learner's header, or, if it is
/// not written yet, the line that says so; 0 if it is not found. The name need not occur in the code ("Bounded +
/// Bounded"): the starter, from which the header was made, shows how the function is declared.
std::size_t line_of_function(std::string_view header, std::string_view starter, std::string_view function);

}  // namespace glassbox::learn
