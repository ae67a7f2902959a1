#pragma once
#include <string>
#include <vector>

#include "learn/check/test_run.hpp"

namespace glassbox::learn {

/// What is so, or not so, of a check's inputs, in words for both.
struct Fact {
    std::string yes;  ///< "the ray starts inside the sphere"
    std::string no;   ///< "the ray does not start inside the sphere"
    bool holds = false;
    bool is_of_the_outcome = false;  ///< of what came out, or should have; says less than what went in
};

/// Returns what is so of a check: of its ray and surface, of its variables, of the numbers that its expression is
/// written with, and of what is expected. The most telling ones first.
std::vector<Fact> facts_of(const CheckMade& check);

}  // namespace glassbox::learn
