# Runs a lesson's program and compares pixels of its picture:
# cmake -D PROGRAM=… -D PICTURE=… -D WIDTH=… -D HEIGHT=… -D "PIXELS=x,y=rrggbb …" -P CheckPicture.cmake
# As in image tools, (0, 0) is the top-left pixel. Colours are in hexadecimal digits.
file(REMOVE ${PICTURE})
execute_process(COMMAND ${PROGRAM} ${PICTURE} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "expected exit status 0, got ${status}")
endif()

string(LENGTH "P6 ${WIDTH} ${HEIGHT} 255 " header)
math(EXPR expected "${header} + 3 * ${WIDTH} * ${HEIGHT}")
file(SIZE ${PICTURE} size)
if(NOT size EQUAL expected)
  message(FATAL_ERROR "expected ${expected} bytes of ${WIDTH}x${HEIGHT} pixels, got ${size}")
endif()

separate_arguments(PIXELS)
foreach(pixel IN LISTS PIXELS)
  string(REGEX MATCH "^([0-9]+),([0-9]+)=(......)$" _ ${pixel})
  set(expected ${CMAKE_MATCH_3})
  math(EXPR offset "${header} + 3 * (${CMAKE_MATCH_2} * ${WIDTH} + ${CMAKE_MATCH_1})")
  file(READ ${PICTURE} got OFFSET ${offset} LIMIT 3 HEX)
  if(NOT got STREQUAL expected)
    message(SEND_ERROR "pixel ${CMAKE_MATCH_1},${CMAKE_MATCH_2}: expected ${expected}, got ${got}")
  endif()
endforeach()

# and says so when it cannot write
execute_process(COMMAND ${PROGRAM} ${PICTURE}/no/such/folder.ppm RESULT_VARIABLE status ERROR_VARIABLE complaint)
if(NOT status EQUAL 1 OR NOT complaint MATCHES "error: cannot write")
  message(SEND_ERROR "into a folder that is not there: expected status 1 and an error, got ${status}: ${complaint}")
endif()
