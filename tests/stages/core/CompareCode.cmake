# Compiles SOURCE with two sets of headers and compares the machine code, instruction by instruction:
# cmake -D CXX=… -D OBJDUMP=… -D SOURCE=… -D "ONE=dir;…" -D "OTHER=dir;…" -D FOLDER=… -P CompareCode.cmake
file(MAKE_DIRECTORY ${FOLDER})
foreach(core ONE OTHER)
  list(TRANSFORM ${core} PREPEND -I)
  execute_process(COMMAND ${CXX} -std=c++20 -O2 -ffp-contract=off ${${core}} -c ${SOURCE} -o ${FOLDER}/${core}.o
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${OBJDUMP} -d -r --no-show-raw-insn ${FOLDER}/${core}.o OUTPUT_VARIABLE code
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "^[^\n]*\n?[^\n]*file format[^\n]*\n" "" code_${core} "${code}")  # it names the file
  file(WRITE ${FOLDER}/${core}.s "${code_${core}}")
  string(REGEX MATCHALL "\n +[0-9a-f]+:\t" lines "${code}")
  list(LENGTH lines count_${core})
endforeach()

if(count_ONE LESS 500)
  message(FATAL_ERROR "expected some hundred instructions to compare, got ${count_ONE}")
endif()
if(NOT code_ONE STREQUAL code_OTHER)
  message(FATAL_ERROR "expected the same machine code, got ${count_ONE} and ${count_OTHER} lines of it: "
                      "see ${FOLDER}/ONE.s and OTHER.s")
endif()
message("the same ${count_ONE} lines of machine code")
