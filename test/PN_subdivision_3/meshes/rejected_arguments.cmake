# cmake -DCOMPILER=... -DFLAGS=... -DSOURCE=... -P rejected_arguments.cmake
# Compiles a file that must not compile: every line after "// expected:" has to be said as often as it is
# there, and every error has to be one of the package's own lines.
execute_process(
  COMMAND ${COMPILER} ${FLAGS} -std=c++17 -fsyntax-only ${SOURCE}
  RESULT_VARIABLE result ERROR_VARIABLE messages OUTPUT_QUIET)
if(result EQUAL 0)
  message(FATAL_ERROR "${SOURCE} compiles")
endif()
string(REPLACE ";" "," messages "${messages}")
string(REGEX MATCHALL "[^\n]*error:[^\n]*" errors "${messages}")
foreach(error IN LISTS errors)
  if(NOT error MATCHES "PN_subdivision_3: ")
    message(SEND_ERROR "not a line of the package's own: ${error}")
  endif()
endforeach()
file(STRINGS ${SOURCE} expected REGEX "// expected: ")
list(LENGTH expected number_expected)
list(LENGTH errors number)
if(number LESS number_expected)
  message(SEND_ERROR "${number} errors, ${number_expected} expected")
endif()
foreach(line IN LISTS expected)
  string(REGEX REPLACE ".*// expected: " "" line "${line}")
  string(FIND "${messages}" "${line}" position)
  if(position EQUAL -1)
    message(SEND_ERROR "missing: ${line}")
  endif()
endforeach()
