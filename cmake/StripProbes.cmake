# The core and the tracing loop without their probes: what they would be if nothing could look inside. Tests and
# benchmarks compare with them: a silent probe should cost nothing.
#
# As a script, copies one header and leaves out every statement `probe(told::…);`:
#   cmake -D IN=… -D OUT=… -P StripProbes.cmake
# Included, it makes the target core_without_probes, whose include directories hold such copies of the first five stages
# and of what render/search/plain_search.hpp needs, followed by the source itself. The copies are in a namespace of
# their own, so that one program can hold both.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  file(READ ${IN} text)
  string(REGEX REPLACE "\n *probe\\(told::[^;]*\\);" "" text "${text}")
  string(REPLACE "namespace glassbox {" "namespace glassbox::inline without_probes {" text "${text}")
  if(text MATCHES "\n[^/\n]*probe\\(told::[^\n]*")
    message(FATAL_ERROR "${IN}: error: a probe that is not a statement of its own: ${CMAKE_MATCH_0}")
  endif()
  file(WRITE ${OUT} "${text}")
  return()
endif()

include_guard(GLOBAL)
set(script ${CMAKE_CURRENT_LIST_FILE})
get_filename_component(source ${CMAKE_CURRENT_LIST_DIR}/../src ABSOLUTE)
set(stripped ${CMAKE_BINARY_DIR}/core_without_probes)
file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${source} ${source}/core/[1-5]-*/*.hpp)
set(stages ${headers})
list(TRANSFORM stages REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES stages)
list(TRANSFORM stages PREPEND ${stripped}/)
list(APPEND headers render/search/plain_search.hpp render/search/surface_normal.hpp render/search/surfaces.hpp scene/scene.hpp)
set(copies ${headers})
list(TRANSFORM copies PREPEND ${stripped}/)
foreach(header copy IN ZIP_LISTS headers copies)
  add_custom_command(OUTPUT ${copy} DEPENDS ${source}/${header} ${script}
                     COMMAND ${CMAKE_COMMAND} -D IN=${source}/${header} -D OUT=${copy} -P ${script} VERBATIM)
endforeach()
add_custom_target(core_without_probes_headers ALL DEPENDS ${copies})

add_library(core_without_probes INTERFACE)
add_dependencies(core_without_probes core_without_probes_headers)
target_include_directories(core_without_probes INTERFACE ${stages} ${stripped} ${source})
target_link_libraries(core_without_probes INTERFACE glassbox_arithmetic)
