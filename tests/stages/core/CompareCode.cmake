# Compiles SOURCE with two sets of headers and compares the machine code, instruction by instruction:
# cmake -D CXX=… -D EXACT=… -D OBJDUMP=… -D SOURCE=… -D "ONE=dir;…" -D "OTHER=dir;…" -D FOLDER=… -P CompareCode.cmake
#
# g++ must generate identical code (EXACT). clang++ does so for every function but shade(): there a value that only the
# probe receives, n·r, is dropped after the registers have been planned, and the same sums are packed in another way. So
# other compilers must only have the same arithmetic and calls, as many of each, and a length within 1 %.
file(MAKE_DIRECTORY ${FOLDER})
foreach(core ONE OTHER)
  list(TRANSFORM ${core} PREPEND -I)
  execute_process(COMMAND ${CXX} -std=c++20 -O2 -ffp-contract=off ${${core}} -c ${SOURCE} -o ${FOLDER}/${core}.o
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${OBJDUMP} -d -r --no-show-raw-insn ${FOLDER}/${core}.o OUTPUT_VARIABLE code
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "^[^\n]*\n?[^\n]*file format[^\n]*\n" "" code_${core} "${code}")  # it names the file
  file(WRITE ${FOLDER}/${core}.s "${code_${core}}")
  string(REGEX MATCHALL "\n +[0-9a-f]+:[ \t]" lines "${code}")
  list(LENGTH lines count_${core})
  string(REGEX MATCHALL "\tv?(add|sub|mul|div|sqrt|u?comi)[sp][sd]|\tf(add|sub|mul|div|sqrt|cmp)|\tcall|\tbl " arithmetic_${core}
         "${code}")
  list(TRANSFORM arithmetic_${core} REPLACE "[sp]([sd])$" "\\1")  # one number at a time, or two packed in a register
  list(SORT arithmetic_${core})
endforeach()

if(count_ONE LESS 500 OR NOT arithmetic_ONE)
  message(FATAL_ERROR "expected some hundred instructions to compare, got ${count_ONE}")
endif()
if(code_ONE STREQUAL code_OTHER)
  message("the same ${count_ONE} lines of machine code")
  return()
endif()
math(EXPR apart "100 * (${count_ONE} - ${count_OTHER}) / ${count_ONE}")
if(EXACT OR NOT arithmetic_ONE STREQUAL arithmetic_OTHER OR NOT apart EQUAL 0)
  message(FATAL_ERROR "expected the same machine code, got ${count_ONE} and ${count_OTHER} lines of it: "
                      "see ${FOLDER}/ONE.s and OTHER.s")
endif()
message("the same arithmetic in ${count_ONE} and ${count_OTHER} lines of machine code")
