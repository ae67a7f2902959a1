#pragma once
#include <string>
#include <string_view>

namespace glassbox {

/// The command that a PNG, PPM or EXR file says makes it again, given all its bytes; empty if it says none, or is
/// something else.
std::string command_in(std::string_view file);

}  // namespace glassbox
