#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace glassbox {

/// The most levels of nested tables and arrays that are allowed. The files read here have three or four.
inline constexpr std::size_t most_toml_levels = 100;

/// Where a TOML text nests tables and arrays deeper than that, if it does: by brackets, by dotted keys (a.b.c = 1), or
/// by both. Call it before parsing: the parser recurses as deep as the text nests, and the stack is limited.
std::optional<std::size_t> first_too_deep(std::string_view toml);

}  // namespace glassbox
