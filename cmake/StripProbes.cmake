# The core without its probes: what the formulas would be if nobody had ever asked to look inside. Tests and benchmarks
# compare with it: a silent probe should cost nothing.
#
# As a script, copies one header and leaves out every statement `probe(told::…);`:
#   cmake -D IN=… -D OUT=… -P StripProbes.cmake
# Included, it makes the target core_without_probes, whose include directories are such copies of all five stages.
if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  file(READ ${IN} text)
  string(REGEX REPLACE "\n *probe\\(told::[^;]*\\);" "" text "${text}")
  if(text MATCHES "\n[^/\n]*probe\\(told::[^\n]*")
    message(FATAL_ERROR "${IN}: error: a probe that is not a statement of its own: ${CMAKE_MATCH_0}")
  endif()
  file(WRITE ${OUT} "${text}")
  return()
endif()

set(script ${CMAKE_CURRENT_LIST_FILE})
get_filename_component(core ${CMAKE_CURRENT_LIST_DIR}/../src/core ABSOLUTE)
set(stripped ${CMAKE_BINARY_DIR}/core_without_probes)
file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${core} ${core}/*/*.hpp)
set(copies ${headers})
list(TRANSFORM copies PREPEND ${stripped}/)
foreach(header copy IN ZIP_LISTS headers copies)
  add_custom_command(OUTPUT ${copy} DEPENDS ${core}/${header} ${script}
                     COMMAND ${CMAKE_COMMAND} -D IN=${core}/${header} -D OUT=${copy} -P ${script} VERBATIM)
endforeach()
add_custom_target(core_without_probes_headers ALL DEPENDS ${copies})

set(folders ${copies})
list(TRANSFORM folders REPLACE "/[^/]*$" "")
list(REMOVE_DUPLICATES folders)
add_library(core_without_probes INTERFACE)
add_dependencies(core_without_probes core_without_probes_headers)
target_include_directories(core_without_probes INTERFACE ${folders})
target_link_libraries(core_without_probes INTERFACE glassbox_arithmetic)
