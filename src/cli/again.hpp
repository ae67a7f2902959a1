#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox {

/// The options that were typed, as they are typed again: " --turn z:10 --size 80x60"; without those of these names.
std::string options_again(const CLI::App& command, const std::vector<std::string_view>& without);

}  // namespace glassbox
