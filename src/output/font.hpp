#pragma once

namespace glassbox {

/// The embedded font file, DejaVu Sans, in TrueType format.
const unsigned char* font_file();

}  // namespace glassbox
