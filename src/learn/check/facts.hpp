#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// What a check calls the function with, where it does so by itself: dot(a, 2 * b) is such a call, and so is
/// quadratic(ray, sphere).a; in size * dot(a, b), or of a variable that an answer was put into, nothing is known.
struct OwnCall {
    std::vector<Input> arguments;  ///< those whose numbers are known: "its first argument", "D of its first argument"
    bool is_whole_answer = false;  ///< the answer is checked, not a member of it
};

/// Returns the call, if the check makes one. `function` is as an exercise names it: "at", "pixel_ray of a parallel
/// view".
std::optional<OwnCall> own_call(const CheckMade& check, std::string_view function);

/// "c" of outside.c and of quadratic(ray, sphere).c; "" where no member is checked.
std::string member_checked(const CheckMade& check);

/// What is so, or not so, of a function's arguments, in words for both.
struct Fact {
    std::string yes;  ///< "its first argument is 0"
    std::string no;   ///< "its first argument is not 0"
    bool holds = false;
    bool is_special = false;  ///< a case that formulas make by itself, as division by 0: few inputs are enough for it
};

/// Returns what is so of a function's arguments. The most telling ones first.
std::vector<Fact> facts_of(const std::vector<Input>& arguments);

}  // namespace glassbox::learn
