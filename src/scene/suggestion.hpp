#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox {

/// How many letters to add, drop, change or swap with their neighbour to turn one word into the other. Ignores case.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The advice for an unknown name: "did you mean 'radius'?", or, if none is near, "it must be one of 'center',
/// 'radius', 'color'".
std::string suggestion(std::string_view unknown, std::span<const std::string_view> known);

/// "did you mean 'room'?", or "" if no name is near: for words that need not be one of these names.
std::string did_you_mean(std::string_view unknown, std::span<const std::string_view> known);
std::string did_you_mean(std::string_view unknown, const std::vector<std::string>& known);

/// "1 test", "2 tests".
std::string counted(std::size_t count, std::string_view thing);

/// "a, b or c", and "a, b and c", of at least one word.
std::string either(const std::vector<std::string>& words);
std::string enumerated(const std::vector<std::string>& words);

}  // namespace glassbox
