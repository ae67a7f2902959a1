#pragma once
#include <cstddef>
#include <string_view>

namespace glassbox::learn {

/// The line, counted from 1, in which a function of an exercise begins in the learner's header, or, where it is not
/// written yet, the line that says so; 0 if it is not found. The name need not stand in the code ("Bounded + Bounded"):
/// the starter, which the header was made from, shows what the function is declared as.
std::size_t line_of_function(std::string_view header, std::string_view starter, std::string_view function);

}  // namespace glassbox::learn
