# How everything is compiled: each operation rounded as written, and warnings on.
#
# -ffp-contract=off: with contraction, the compilers' default, a·b − c·d no longer equals −(c·d − a·b), and rays slip
# between two triangles that share an edge.
add_library(glassbox_arithmetic INTERFACE)
target_compile_options(glassbox_arithmetic INTERFACE -ffp-contract=off)

add_library(glassbox_warnings INTERFACE)
target_compile_options(glassbox_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor)
if(GLASSBOX_WERROR)
  target_compile_options(glassbox_warnings INTERFACE -Werror)
endif()
