#include "output/font.hpp"

// The assembler copies the font file's bytes in here; C++ has no #embed yet. Mach-O puts an underscore before C names.
#if defined(__APPLE__)
#define GLASSBOX_SECTION "__TEXT,__const"
#define GLASSBOX_SYMBOL "_glassbox_font"
#else
#define GLASSBOX_SECTION ".rodata"
#define GLASSBOX_SYMBOL "glassbox_font"
#endif

asm(".pushsection " GLASSBOX_SECTION
    "\n"
    ".globl " GLASSBOX_SYMBOL
    "\n"
    ".p2align 4\n" GLASSBOX_SYMBOL
    ":\n"
    ".incbin \"" GLASSBOX_FONT
    "\"\n"
    ".popsection\n");

extern "C" const unsigned char glassbox_font[];

namespace glassbox {

const unsigned char* font_file() { return glassbox_font; }

}  // namespace glassbox
