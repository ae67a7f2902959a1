# The font of all legends is part of the program, so that it draws the same text everywhere and needs no font file to run.
find_file(GLASSBOX_FONT DejaVuSans.ttf
  PATHS /usr/share/fonts /usr/local/share/fonts /Library/Fonts $ENV{HOME}/Library/Fonts $ENV{HOME}/.local/share/fonts
  PATH_SUFFIXES truetype/dejavu dejavu-sans-fonts dejavu TTF
  DOC "DejaVuSans.ttf, embedded in the program")
if(NOT GLASSBOX_FONT)
  message(FATAL_ERROR "DejaVuSans.ttf is missing. Install fonts-dejavu-core (Debian, Ubuntu), dejavu-sans-fonts (Fedora), "
    "ttf-dejavu (Arch) or font-dejavu (brew), or configure with -DGLASSBOX_FONT=/path/to/DejaVuSans.ttf.")
endif()

# glassbox_embed_font(source): that source file's .incbin takes in the font; it is compiled again when the font changes.
function(glassbox_embed_font source)
  set_source_files_properties(${source} PROPERTIES
    COMPILE_DEFINITIONS GLASSBOX_FONT="${GLASSBOX_FONT}" OBJECT_DEPENDS "${GLASSBOX_FONT}")
endfunction()
