#pragma once
#include <span>

namespace glassbox {

/// The embedded font file, DejaVu Sans, in TrueType format.
std::span<const unsigned char> font_file();

}  // namespace glassbox
