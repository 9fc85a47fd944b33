# The package as its users get it: installed without having been built, as a subfolder, and with parts
# of what it needs missing; and the README's example is the one that is built here.

set(pn_readme_example ${PN_subdivision_3_SOURCE_DIR}/examples/PN_subdivision_3/readme_example.cpp)
set(pn_consumer_dir ${PN_subdivision_3_BINARY_DIR}/consumer)
set(pn_prefix ${pn_consumer_dir}/prefix)

add_test(
  NAME readme_shows_the_example
  COMMAND ${CMAKE_COMMAND} -DREADME=${PN_subdivision_3_SOURCE_DIR}/README.md
          -DEXAMPLE=${pn_readme_example} -P ${CMAKE_CURRENT_LIST_DIR}/PN_compare_readme.cmake)

# --- configuring the package where something is missing ---
function(pn_configure_without package expected)
  set(name configure_without_${package})
  add_test(
    NAME ${name}
    COMMAND ${CMAKE_COMMAND} -S ${PN_subdivision_3_SOURCE_DIR} -B ${pn_consumer_dir}/${name}
            -G ${CMAKE_GENERATOR} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
            -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
  set_tests_properties(${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}"
                       FAIL_REGULAR_EXPRESSION "CGAL_TBB_support")
endfunction()
pn_configure_without(CGAL "PN_subdivision_3 needs CGAL 5.5 or newer, which was not")
pn_configure_without(Eigen3 "tests are left out: [^\n]*test_schemes.*Configuring done")
pn_configure_without(GTest "GoogleTest not found, the unit tests are left out.*Configuring done")

# --- as CGAL's test suite does: the folder of the tests by itself ---
add_test(NAME tests_by_themselves
         COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR} -B ${pn_consumer_dir}/tests_by_themselves
                 -G ${CMAKE_GENERATOR} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER})
set_tests_properties(tests_by_themselves PROPERTIES PASS_REGULAR_EXPRESSION
                                                    "the plain programs.*Configuring done")

# --- installed ---
# Configures with the default options and installs, without a build in between.
add_test(
  NAME install_without_building
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PN_subdivision_3_SOURCE_DIR} -DFOLDER=${pn_consumer_dir}
          -DPREFIX=${pn_prefix} -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER}
          -P ${CMAKE_CURRENT_LIST_DIR}/PN_install_without_building.cmake)
set_tests_properties(install_without_building PROPERTIES FIXTURES_SETUP pn_installed)

set(pn_installed_components)
foreach(component_and_target Eigen=Eigen3::Eigen TBB=CGAL::TBB_support)
  string(REPLACE "=" ";" component_and_target ${component_and_target})
  list(GET component_and_target 1 target)
  if(TARGET ${target})
    list(GET component_and_target 0 component)
    list(APPEND pn_installed_components ${component})
  endif()
endforeach()
list(JOIN pn_installed_components "," pn_installed_components)

# pn_add_consumer_test(name folder program option...): configures a folder, builds a program and runs it.
function(pn_add_consumer_test name folder program)
  add_test(
    NAME ${name}
    COMMAND
      ${CMAKE_CTEST_COMMAND} --build-and-test ${folder} ${pn_consumer_dir}/${name}
      --build-generator ${CMAKE_GENERATOR} --build-target ${program} --build-options
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_CXX_FLAGS_RELEASE=${PN_TEST_OPTIMIZATION} ${ARGN} --test-command ${program})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600)
endfunction()

pn_add_consumer_test(
  install_consumer ${CMAKE_CURRENT_SOURCE_DIR}/install_consumer readme_example
  -DREADME_EXAMPLE=${pn_readme_example} -DCMAKE_PREFIX_PATH=${pn_prefix}
  -DCOMPONENTS=${pn_installed_components})
# an example that reads a mesh, without arguments and without the package's folder
pn_add_consumer_test(
  installed_examples ${pn_prefix}/share/PN_subdivision_3/examples/PN_subdivision_3 polyhedron
  -DCMAKE_PREFIX_PATH=${pn_prefix})
set_tests_properties(install_consumer installed_examples PROPERTIES FIXTURES_REQUIRED pn_installed)

if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.24)
  pn_add_consumer_test(
    subdirectory_consumer ${CMAKE_CURRENT_SOURCE_DIR}/subdirectory_consumer readme_example
    -DREADME_EXAMPLE=${pn_readme_example} -DPACKAGE_DIR=${PN_subdivision_3_SOURCE_DIR})
else()
  pn_left_out(subdirectory_consumer "CMake 3.24 not found, the test of a package in a subfolder is left out")
endif()
