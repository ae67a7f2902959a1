#pragma once
#include <string>
#include <vector>

#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// Whether two numbers are as good as the same, to a millionth of the larger; what is not a number is the same.
bool as_good_as_equal(double a, double b);

/// Returns what all wrong answers have in common, as the end of a sentence: "is half of what is expected"; "" if that
/// is nothing that we know of. Each of `wrong` is a failed check that compares numbers, or each is a condition.
std::string relation_of(const std::vector<const CheckMade*>& wrong);

}  // namespace glassbox::learn
