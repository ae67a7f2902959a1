#pragma once
#include <string>

namespace glassbox::learn {

/// Returns a test's source in which each check, CHECK…(…); or REQUIRE…(…);, is told which variables it is made from:
/// those that it names, and those that they were computed from, eight at most (tests/support/seen.hpp). A check without
/// variables stays as it is. Each line keeps its number, and what reports on one names `file`.
std::string with_seen_variables(const std::string& source, const std::string& file);

}  // namespace glassbox::learn
