# pn_left_out(name reason... [OPTIONAL]): tests that cannot be had here because something is missing. They are
# registered, and skipped with the reason; scripts/test.sh counts them and, with --strict, fails, but for those
# that are OPTIONAL. A program that finds something missing where it runs begins a line with the same words
# (GTEST_SKIP() << "left out: ..."); a test that does not apply to its type or processor is skipped with
# "does not apply: ...". Whatever is skipped with neither counts as missing.
function(pn_left_out name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIONAL" "" "")
  string(CONCAT reason ${arg_UNPARSED_ARGUMENTS})
  message(STATUS "PN_subdivision_3: ${reason}")
  set(words "left out: ")
  if(arg_OPTIONAL)
    set(words "left out, as it may be: ")
  endif()
  add_test(NAME left_out.${name} COMMAND ${CMAKE_COMMAND} -E echo "${words}${reason}")
  set_tests_properties(left_out.${name} PROPERTIES SKIP_REGULAR_EXPRESSION "^left out")
endfunction()
