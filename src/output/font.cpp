#include "output/font.hpp"

#include "output/embed.hpp"

GLASSBOX_EMBED(glassbox_font, GLASSBOX_FONT);

namespace glassbox {

std::span<const unsigned char> font_file() { return {glassbox_font, glassbox_font_end}; }

}  // namespace glassbox
