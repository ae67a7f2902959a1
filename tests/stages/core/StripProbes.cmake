# The core without its probes: what it would be if nothing could look inside. A test compares its machine code with the
# core's: a silent probe costs nothing.
#
# As a script, copies one header and leaves out every statement `probe(told::…);`:
#   cmake -D IN=… -D OUT=… -P StripProbes.cmake
# Included, it makes such copies of the headers of the first five stages as the build's target core_without_probes, and
# lists their folders in CORE_WITHOUT_PROBES.
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
set(source ${PROJECT_SOURCE_DIR}/src/core)
set(stripped ${CMAKE_CURRENT_BINARY_DIR}/core_without_probes)
file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${source} ${source}/[1-5]-*/*.hpp)
set(CORE_WITHOUT_PROBES "")
set(copies "")
foreach(header IN LISTS headers)
  set(copy ${stripped}/${header})
  add_custom_command(OUTPUT ${copy} DEPENDS ${source}/${header} ${script}
                     COMMAND ${CMAKE_COMMAND} -D IN=${source}/${header} -D OUT=${copy} -P ${script} VERBATIM)
  list(APPEND copies ${copy})
  cmake_path(GET copy PARENT_PATH folder)
  list(APPEND CORE_WITHOUT_PROBES ${folder})
endforeach()
list(REMOVE_DUPLICATES CORE_WITHOUT_PROBES)
add_custom_target(core_without_probes ALL DEPENDS ${copies})
