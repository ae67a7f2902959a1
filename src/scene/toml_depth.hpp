#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace glassbox {

/// The most levels that tables and arrays may be nested in each other. What is read here has three or four.
inline constexpr std::size_t most_toml_levels = 100;

/// Where a TOML text nests tables and arrays deeper than that, if it does: by brackets, by dotted keys (a.b.c = 1), by
/// both. Asked before it is parsed, for a parser goes down as deep as the text does, and the stack has an end.
std::optional<std::size_t> first_too_deep(std::string_view toml);

}  // namespace glassbox
