#pragma once

// GLASSBOX_EMBED(name, "path"): the file's bytes as name[], up to name_end. The assembler copies them in, since C++ has
// no #embed yet. Use at namespace scope, once per program. Mach-O has other sections, and an underscore before C names.
#if defined(__APPLE__)
#define GLASSBOX_SECTION "__TEXT,__const"
#define GLASSBOX_SYMBOL(name) "_" #name
#else
#define GLASSBOX_SECTION ".rodata"
#define GLASSBOX_SYMBOL(name) #name
#endif

#define GLASSBOX_EMBED(name, path)                                                                                 \
    asm(".pushsection " GLASSBOX_SECTION "\n.globl " GLASSBOX_SYMBOL(name) "\n.globl " GLASSBOX_SYMBOL(            \
        name##_end) "\n.p2align 4\n" GLASSBOX_SYMBOL(name) ":\n.incbin \"" path                                    \
                                                           "\"\n" GLASSBOX_SYMBOL(name##_end) ":\n.popsection\n"); \
    extern "C" const unsigned char name[], name##_end[]
