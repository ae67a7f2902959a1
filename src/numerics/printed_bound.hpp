#pragma once
#include <string>
#include <string_view>

namespace glassbox {

// Prints a number and a bound on its error so that the bound still holds after rounding. All numbers must be finite.

/// The shortest decimal that reads back to the same double.
std::string shortest(double value);

/// Whether the printed number is that decimal, apart from trailing zeros.
bool is_shortest(std::string_view printed, double value);

/// A number of 0 or more, rounded up to that many digits.
std::string rounded_up(double value, int digits);

/// A value with the digits that its bound justifies: down to the bound's second digit, but at least two, and no more
/// than tell any two doubles apart. Without an error, all of its digits, or the shortest form if those are too many.
std::string value_beside(double value, double error);

/// The bound to print for a value printed as `printed`: at least the error plus what printing rounded off. "0" if both
/// are 0.
std::string bound_beside(std::string_view printed, double value, double error, int digits = 2);

/// The double to print in place of a bound, in the shortest form that reads back. That form is at least as near to this
/// double as to the bound, its lower neighbour, and so is above the bound.
double bound_to_print(double error);

}  // namespace glassbox
