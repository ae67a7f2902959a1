# Installs BUILD into a new folder, and renders a scene by its bare name with the installed program, in another folder.
set(prefix ${BUILD}/installed)
set(elsewhere ${BUILD}/elsewhere)
file(REMOVE_RECURSE ${prefix} ${elsewhere})
file(MAKE_DIRECTORY ${elsewhere})

execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${prefix}/bin/glassbox render levental-2014 -o picture.ppm
  WORKING_DIRECTORY ${elsewhere} COMMAND_ERROR_IS_FATAL ANY)

file(READ ${elsewhere}/picture.ppm start LIMIT 15 HEX)
string(HEX "P6\n500 500\n255\n" expected)
if(NOT start STREQUAL expected)
  message(FATAL_ERROR "picture.ppm should begin with ${expected}; it begins with ${start}")
endif()
