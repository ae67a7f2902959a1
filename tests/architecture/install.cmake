# Installs BUILD into a new folder, and from another folder uses what is there as somebody would who has no more: renders a
# scene by its bare name, begins a lesson and passes a function of it, builds the example on the installed package.
set(prefix ${BUILD}/installed)
# Not in the project: the lessons are taken from the folders above first.
set(temporary $ENV{TMPDIR})
if(NOT temporary)
  set(temporary /tmp)
endif()
string(RANDOM LENGTH 12 name)
set(elsewhere ${temporary}/glassbox-installed-${name})
file(REMOVE_RECURSE ${prefix})
file(MAKE_DIRECTORY ${elsewhere})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)

# in_elsewhere(STATUS COMMAND…): runs it there, and expects that exit status; what it says is `said`.
function(in_elsewhere status)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${elsewhere} RESULT_VARIABLE got OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT got EQUAL status)
    message(FATAL_ERROR "${ARGN}: expected the exit status ${status}, got ${got}:\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()
function(expect_said part)
  string(FIND "${said}" "${part}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "expected to read '${part}', got:\n${said}")
  endif()
endfunction()

set(glassbox ${prefix}/bin/glassbox)
in_elsewhere(0 ${glassbox} render levental-2014 -o picture.ppm)
file(STRINGS ${elsewhere}/picture.ppm start LIMIT_COUNT 5)
if(NOT start MATCHES "^P6;# Software: Glassbox [0-9.]+;# Command: glassbox render levental-2014 -o levental-2014.ppm;500 500;255$")
  message(FATAL_ERROR "picture.ppm should begin with P6, two comments, 500 500 and 255; it begins with ${start}")
endif()
in_elsewhere(0 ${glassbox} explain levental-2014 --pixel 360,379)
in_elsewhere(0 ${glassbox} doctor)
expect_said("${prefix}/share/glassbox/scenes")

# Each page that is there leads to pages that are there.
foreach(folder share/glassbox share/doc/glassbox)
  file(GLOB_RECURSE pages FOLLOW_SYMLINKS RELATIVE ${prefix}/${folder} ${prefix}/${folder}/*.md)
  execute_process(COMMAND awk -f ${CMAKE_CURRENT_LIST_DIR}/../lessons/links.awk ${pages} WORKING_DIRECTORY ${prefix}/${folder}
    RESULT_VARIABLE status ERROR_VARIABLE said OUTPUT_VARIABLE said)
  list(LENGTH pages count)
  if(status OR count LESS 15)
    message(FATAL_ERROR "the ${count} pages of ${folder} should lead to one another:\n${said}")
  endif()
endforeach()

# What a lesson names by its place in the project is found.
in_elsewhere(0 ${glassbox} shoot triangle --rays lessons/1-rays/rays.csv)

# my/ is made where one stands; the lessons are the installed ones.
in_elsewhere(0 ${glassbox} learn status)
expect_said("${prefix}/share/glassbox/lessons/1-rays/README.md")
in_elsewhere(1 ${glassbox} learn test 1)
expect_said("Next to write: dot in my/1-rays/vec3.hpp")
file(READ ${elsewhere}/my/1-rays/vec3.hpp text)
string(REPLACE "return not_written<Real>(\"dot\");" "return a.x * b.x + a.y * b.y + a.z * b.z;" text "${text}")
file(WRITE ${elsewhere}/my/1-rays/vec3.hpp "${text}")
in_elsewhere(1 ${glassbox} learn test 1)
expect_said("✓ dot")

if(EXAMPLE)
  in_elsewhere(0 ${CMAKE_COMMAND} -G ${GENERATOR} -S ${EXAMPLE} -B example -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_CXX_FLAGS=${FLAGS})
  in_elsewhere(0 ${CMAKE_COMMAND} --build example)
  in_elsewhere(0 ${elsewhere}/example/asks_glassbox)
  expect_said("first: triangle 0 at t = 333333.33333333331 ± ")
endif()
file(REMOVE_RECURSE ${elsewhere})
