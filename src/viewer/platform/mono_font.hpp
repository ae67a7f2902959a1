#pragma once
#include <span>

namespace glassbox {

/// The embedded font file, DejaVu Sans Mono, in TrueType format.
std::span<const unsigned char> mono_font_file();

}  // namespace glassbox
