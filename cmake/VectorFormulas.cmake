# The core's formulas for vectors. Highway compiles the engine's inner loops once for each kind of vectors, and a
# template is compiled for a kind only if it stands among that code: so the loops include this copy each time, in a
# namespace of their own. It is the core's headers without #pragma once, #include and namespace: no formula is written
# twice.
#
# As a script, copies the headers:
#   cmake -D "HEADERS=…;…" -D OUT=… -P VectorFormulas.cmake
# Included, it gives glassbox_vector_formulas(target headers…): the target can include engine_formulas.inl.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  set(copy "// Written by cmake/VectorFormulas.cmake.\n")
  foreach(header IN LISTS HEADERS)
    file(READ ${header} text)
    string(REGEX REPLACE "\n?#(pragma once|include)[^\n]*" "" text "${text}")
    string(REGEX REPLACE "namespace glassbox {" "" text "${text}")
    string(REGEX REPLACE "}  // namespace glassbox\n" "" text "${text}")
    string(APPEND copy "${text}")
  endforeach()
  file(WRITE ${OUT} "${copy}")
  return()
endif()

set(GLASSBOX_VECTOR_FORMULAS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(glassbox_vector_formulas target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/formulas)
  add_custom_command(OUTPUT ${folder}/engine_formulas.inl DEPENDS ${ARGN} ${GLASSBOX_VECTOR_FORMULAS_SCRIPT}
    COMMAND ${CMAKE_COMMAND} -D "HEADERS=${ARGN}" -D OUT=${folder}/engine_formulas.inl -P ${GLASSBOX_VECTOR_FORMULAS_SCRIPT} VERBATIM)
  target_sources(${target} PRIVATE ${folder}/engine_formulas.inl)
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
