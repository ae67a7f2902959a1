#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// Whether two numbers are as good as the same, to a millionth of the larger; what is not a number is the same.
bool as_good_as_equal(double a, double b);

/// Returns what all wrong numbers, or vectors, have in common, as the end of a sentence: "is half of what is expected";
/// "" if that is nothing that we know of. Each of `wrong` is a failed check that compares numbers. What could be so by
/// chance, such as a factor, is only said of three checks or more that expect something else each. `function` is the
/// one that is tested: only what it is given, and what it returns, is spoken of.
std::string relation_of(const std::vector<const CheckMade*>& wrong, std::string_view function);

}  // namespace glassbox::learn
