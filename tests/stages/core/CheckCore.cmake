# Compiles everything.cpp without exceptions and run-time types, and checks what it depends on:
# cmake -D CXX=… -D NM=… -D "INCLUDES=dir;…" -D SOURCE=… -D OBJECT=… -P CheckCore.cmake
list(TRANSFORM INCLUDES PREPEND -I)
set(compile ${CXX} -std=c++20 -O2 -ffp-contract=off -fno-exceptions -fno-rtti ${INCLUDES})
execute_process(COMMAND ${compile} -c ${SOURCE} -o ${OBJECT} RESULT_VARIABLE status ERROR_VARIABLE complaint)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "expected the core to compile with -fno-exceptions -fno-rtti:\n${complaint}")
endif()

# The headers that it includes, directly or not, contain no stream, no string, no container that allocates. (<optional>
# includes <new> for its placement form; what is really called is checked below.)
execute_process(COMMAND ${compile} -M ${SOURCE} OUTPUT_VARIABLE headers COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^ \\\n]*/(iostream|istream|ostream|iosfwd|sstream|fstream|iomanip|string|vector|deque|list|map|set|unordered_map|memory|functional)[ \\\n]"
       unwanted "${headers} ")
if(unwanted)
  message(SEND_ERROR "the core should include neither streams nor anything that allocates, but pulls in ${unwanted}")
endif()

# Outside itself, it calls arithmetic only.
if(NM)
  execute_process(COMMAND ${NM} -u ${OBJECT} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[A-Za-z_][A-Za-z_0-9]+" symbols "${symbols}")
  list(FILTER symbols EXCLUDE REGEX
       "^_?_?(sqrt|pow|cos|sin|sincos|tan|remquo)[fl]?$|_GLOBAL_OFFSET_TABLE_|__stack_chk_fail")
  if(symbols)
    message(SEND_ERROR "the core should call roots, powers and angles only, but calls ${symbols}")
  endif()
endif()
