# Two tiers of tests: what scripts/test.sh builds and runs, and what test/PN_subdivision_3/long_tests.txt names, which has the
# label "long" in ctest. Its programs are built by the target pn_long_tests, with PN_TEST_FULL by default.
option(PN_TEST_FULL "Build the long tests, too: every scheme with every number type, every header alone" OFF)
set(pn_long_list ${CMAKE_CURRENT_LIST_DIR}/../test/PN_subdivision_3/long_tests.txt)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pn_long_list})
file(STRINGS ${pn_long_list} pn_long_tests REGEX "^[a-z]")
file(STRINGS ${pn_long_list} pn_long_cases REGEX "^ ")
list(TRANSFORM pn_long_cases STRIP)
list(TRANSFORM pn_long_cases REPLACE ":" "?") # which would separate two of them
list(JOIN pn_long_cases ":" pn_long_cases)
add_custom_target(pn_long_tests)

# pn_tier(test [program]): the tier of a test, and of the program that it runs.
function(pn_tier test)
  if(NOT test IN_LIST pn_long_tests AND NOT test MATCHES "^test_long_")
    return()
  endif()
  set_tests_properties(${test} PROPERTIES LABELS long)
  foreach(program ${ARGN})
    add_dependencies(pn_long_tests ${program})
    if(NOT PN_TEST_FULL)
      set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
  endforeach()
endfunction()

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
