#include "viewer/platform/mono_font.hpp"

#include "output/embed.hpp"

GLASSBOX_EMBED(glassbox_mono_font, GLASSBOX_MONO_FONT);

namespace glassbox {

std::span<const unsigned char> mono_font_file() { return {glassbox_mono_font, glassbox_mono_font_end}; }

}  // namespace glassbox
