# cmake -DSCRIPT=.../left_out.sh -DBASH=... -DCTEST=... -DGENERATOR=... -DFOLDER=... -P: what is missing is
# counted, and fails with --strict only.

# expect(name strict code last option...): the exit code of left_out.sh and what it says last, after the tests of
# the project have run, configured with the options
function(expect name strict code last)
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${CMAKE_CURRENT_LIST_DIR} -B ${FOLDER}/${name} ${ARGN}
                  RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
  execute_process(COMMAND ${CTEST} WORKING_DIRECTORY ${FOLDER}/${name} RESULT_VARIABLE tests_failed
                  OUTPUT_VARIABLE tests ERROR_VARIABLE tests)
  if(failed OR tests_failed)
    message(FATAL_ERROR "${name}: nothing that is left out makes a test fail:\n${log}${tests}")
  endif()
  execute_process(COMMAND ${BASH} ${SCRIPT} ${strict} ${FOLDER}/${name}
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT result EQUAL code OR NOT out MATCHES "(^|\n)${last}\n$")
    message(SEND_ERROR "${name} ${strict}: exit code ${result}, expected ${code}, and last\n${last}\n${out}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(missing "4 tests left out, since something is missing: ranks, in_program, partly, no_reason")
expect(nothing "" 0 "No test was left out\\.")
expect(nothing "--strict" 0 "No test was left out\\.")
expect(missing "" 0 "${missing}" -DMISSING=ON)
expect(missing "--strict" 1 "${missing}" -DMISSING=ON)
set(page "1 test left out, since something is missing: the_page")
expect(page "" 0 "${page}" -DOPTIONAL_MISSING=ON)
expect(page "--strict" 0 "${page}" -DOPTIONAL_MISSING=ON)
expect(both "--strict" 1 "5 tests left out, since something is missing: the_page, ranks, in_program, partly, no_reason"
       -DMISSING=ON -DOPTIONAL_MISSING=ON)

# no log is no success
execute_process(COMMAND ${BASH} ${SCRIPT} --strict ${FOLDER}/elsewhere RESULT_VARIABLE result
                OUTPUT_QUIET ERROR_QUIET)
if(NOT result EQUAL 2)
  message(SEND_ERROR "without a log the exit code is ${result}, expected 2")
endif()
