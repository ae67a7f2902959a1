# glassbox_embed_sources(source table root files…): the source file can include "<table>.inc", which embeds the text
# files with GLASSBOX_EMBED (output/embed.hpp) and defines the table embedded_<table>: each file's path relative to
# `root`, and its text. The source file is compiled again when one of them changes.
function(glassbox_embed_sources source table root)
  set(embeds "// Written by cmake/EmbedSources.cmake.\n")
  set(rows "")
  foreach(file IN LISTS ARGN)
    file(RELATIVE_PATH path ${root} ${file})
    string(MAKE_C_IDENTIFIER "glassbox_${path}" name)
    string(APPEND embeds "GLASSBOX_EMBED(${name}, \"${file}\");\n")
    string(APPEND rows
      "    {\"${path}\", {reinterpret_cast<const char*>(${name}), reinterpret_cast<const char*>(${name}_end)}},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${table}.inc @ONLY
    CONTENT "${embeds}\nnamespace glassbox {\n\nstatic const SourceFile embedded_${table}[] = {\n${rows}};\n\n}  // namespace glassbox\n")
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${ARGN}" INCLUDE_DIRECTORIES ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
