#pragma once
#include <string>
#include <string_view>

namespace glassbox {

// How a number and a bound on its error are printed: rounding must not make the bound a lie. All numbers are finite.

/// The shortest decimal that reads back to the same double.
std::string shortest(double value);

/// Whether what is printed is that decimal, whatever zeros it ends in.
bool is_shortest(std::string_view printed, double value);

/// A number of 0 or more with so many digits, not below it.
std::string rounded_up(double value, int digits);

/// A value with the digits that its bound deserves: down to the bound's second digit, but at least two, and no more
/// than tell any two doubles apart. Without an error all of its digits, or the shortest, if those are too many.
std::string value_beside(double value, double error);

/// The bound for a value that was printed so: not below the error together with what the print is off. "0" if both are
/// nothing.
std::string bound_beside(std::string_view printed, double value, double error, int digits = 2);

/// The double to print in place of a bound, in the shortest form that reads back. That form is at least
/// as near to this double as to the bound, its neighbour below, and so is above the bound.
double bound_to_print(double error);

}  // namespace glassbox
