#pragma once
#include <string>
#include <string_view>

namespace glassbox::learn {

/// The operator that an error is about and what stands on its two sides, as far as the source shows it.
struct OperatorInSource {
    std::string left = "vector", sign, right = "number";
};

/// Returns a message with the tests' own types called by what a learner calls them: Real, and the Truth that comparing
/// two of them answers.
std::string in_our_names(std::string message);

/// Returns what a compiler error means and what to do about it, for someone who learns C++; empty if it is not one of
/// the common ones. Knows the messages of g++ and of clang++.
std::string in_plain_words(std::string_view message, const OperatorInSource& operation = {});

}  // namespace glassbox::learn
