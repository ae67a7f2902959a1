# The fonts are part of the program, so that it draws the same text everywhere and needs no font file to run.
#
# glassbox_find_font(variable file): the cache variable is that font file's path, or …-NOTFOUND.
function(glassbox_find_font variable file)
  find_file(${variable} ${file}
    PATHS /usr/share/fonts /usr/local/share/fonts /Library/Fonts $ENV{HOME}/Library/Fonts $ENV{HOME}/.local/share/fonts
    PATH_SUFFIXES truetype/dejavu dejavu-sans-fonts dejavu-sans-mono-fonts dejavu TTF
    DOC "${file}, embedded in the program")
endfunction()

# glassbox_embed_font(source variable): GLASSBOX_EMBED (output/embed.hpp) in that source file includes the font, under
# the name of the variable; the file is compiled again when the font changes.
function(glassbox_embed_font source variable)
  set_source_files_properties(${source} PROPERTIES
    COMPILE_DEFINITIONS ${variable}="${${variable}}" OBJECT_DEPENDS "${${variable}}")
endfunction()

glassbox_find_font(GLASSBOX_FONT DejaVuSans.ttf)
if(NOT GLASSBOX_FONT)
  message(FATAL_ERROR "DejaVuSans.ttf is missing. Install fonts-dejavu-core (Debian, Ubuntu), dejavu-sans-fonts (Fedora), "
    "ttf-dejavu (Arch) or font-dejavu (brew), or configure with -DGLASSBOX_FONT=/path/to/DejaVuSans.ttf.")
endif()
