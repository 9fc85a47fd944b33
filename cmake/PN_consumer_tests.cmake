# The package as its users get it: installed, as a subfolder, and with -I include; and the README's
# example is the one that is built here.

set(pn_readme_example ${PN_subdivision_3_SOURCE_DIR}/examples/PN_subdivision_3/readme_example.cpp)
set(pn_consumer_dir ${PN_subdivision_3_BINARY_DIR}/consumer)

add_test(
  NAME readme_shows_the_example
  COMMAND ${CMAKE_COMMAND} -DREADME=${PN_subdivision_3_SOURCE_DIR}/README.md
          -DEXAMPLE=${pn_readme_example} -P ${CMAKE_CURRENT_LIST_DIR}/PN_compare_readme.cmake)

# Configures, builds and runs test/.../<name>.
function(pn_add_consumer_test name)
  add_test(
    NAME ${name}
    COMMAND
      ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/${name}
      ${pn_consumer_dir}/${name} --build-generator ${CMAKE_GENERATOR} --build-options
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DREADME_EXAMPLE=${pn_readme_example} ${ARGN} --test-command readme_example)
  set_tests_properties(${name} PROPERTIES TIMEOUT 600)
endfunction()

add_test(NAME install COMMAND ${CMAKE_COMMAND} --install ${PN_subdivision_3_BINARY_DIR}
                              --component PN_subdivision_3 --prefix ${pn_consumer_dir}/prefix)
set_tests_properties(install PROPERTIES FIXTURES_SETUP pn_installed)

pn_add_consumer_test(install_consumer -DCMAKE_PREFIX_PATH=${pn_consumer_dir}/prefix)
set_tests_properties(install_consumer PROPERTIES FIXTURES_REQUIRED pn_installed)

if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.24)
  pn_add_consumer_test(subdirectory_consumer -DPACKAGE_DIR=${PN_subdivision_3_SOURCE_DIR})
endif()
