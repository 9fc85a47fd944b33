# The test of demo/PN_subdivision_3, where everything that the page needs is there: it builds the page, which
# takes some minutes unless nothing has changed.
find_program(PN_EMCMAKE emcmake)
find_program(PN_CHROMIUM chromium)
find_program(PN_NODE node)
find_program(PN_BASH bash)
if(PN_EMCMAKE AND PN_CHROMIUM AND PN_NODE AND PN_BASH AND TARGET pn_subdivide
   AND EXISTS ${PN_subdivision_3_SOURCE_DIR}/demo/PN_subdivision_3/node_modules/playwright-core)
  add_test(NAME page COMMAND ${PN_BASH} ${PN_subdivision_3_SOURCE_DIR}/scripts/test_page.sh --offline
                             --command $<TARGET_FILE:pn_subdivide>)
  set_tests_properties(page PROPERTIES TIMEOUT 3000 ENVIRONMENT "CHROMIUM=${PN_CHROMIUM}")
else()
  pn_left_out(page "the tools of the page not found (scripts/test_page.sh installs them and tests it)" OPTIONAL)
endif()
