# The package as its users get it: installed without having been built, as a subfolder, and with parts
# of what it needs missing.

set(pn_readme_example ${PN_subdivision_3_SOURCE_DIR}/examples/PN_subdivision_3/readme_example.cpp)
set(pn_consumer_dir ${PN_subdivision_3_BINARY_DIR}/consumer)
set(pn_prefix ${pn_consumer_dir}/prefix)

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
pn_configure_without(TBB "TBB not found, Parallel_tag is left out.*Configuring done")
pn_configure_without(GTest "GoogleTest not found, the unit tests are left out.*Configuring done")

# --- what must be found, and is not ---
foreach(name_and_package EIGEN=Eigen3=libeigen3-dev TBB=TBB=libtbb-dev)
  string(REPLACE "=" ";" name_and_package ${name_and_package})
  list(POP_FRONT name_and_package name package debian)
  add_test(
    NAME configure_with_missing_${package}
    COMMAND ${CMAKE_COMMAND} -S ${PN_subdivision_3_SOURCE_DIR}
            -B ${pn_consumer_dir}/configure_with_missing_${package} -G ${CMAKE_GENERATOR}
            -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON
            -DPN_SUBDIVISION_3_WITH_${name}=ON)
  set_tests_properties(
    configure_with_missing_${package}
    PROPERTIES PASS_REGULAR_EXPRESSION "not found.*${debian}.*PN_SUBDIVISION_3_WITH_${name} is[ \n]+ON")
endforeach()

# an MPI without its headers, which ends CMake's FindMPI
if(TARGET pn_subdivide AND UNIX)
  foreach(wrapper open_mpi mpich)
    foreach(choice default AUTO ON)
      set(name configure_without_headers_of_${wrapper}_${choice})
      set(option -DPN_SUBDIVISION_3_WITH_MPI=${choice})
      set(expected "MPI is left out[^\n]*/no/such[^\n]* does not exist .Debian package libopenmpi-dev.*Configuring done")
      if(choice STREQUAL "default")
        set(option)
        set(expected "Configuring done")
      elseif(choice STREQUAL "ON")
        set(expected "MPI is left out.*/no/such.*not[ \n]+exist.*libopenmpi-dev.*PN_SUBDIVISION_3_WITH_MPI is ON")
      endif()
      add_test(
        NAME ${name}
        COMMAND ${CMAKE_COMMAND} -S ${PN_subdivision_3_SOURCE_DIR} -B ${pn_consumer_dir}/${name}
                -G ${CMAKE_GENERATOR} -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
                -DMPI_CXX_COMPILER=${CMAKE_CURRENT_SOURCE_DIR}/mpi_wrappers/${wrapper} ${option}
                -DPN_SUBDIVISION_3_TESTS=OFF -DPN_SUBDIVISION_3_EXAMPLES=OFF
                -DPN_SUBDIVISION_3_BENCHMARKS=OFF)
      set_tests_properties(${name} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}")
    endforeach()
  endforeach()
endif()

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
  COMMAND ${CMAKE_COMMAND} -DTEST=install_without_building -DSOURCE=${PN_subdivision_3_SOURCE_DIR} -DFOLDER=${pn_consumer_dir}
          -DPREFIX=${pn_prefix} -DGENERATOR=${CMAKE_GENERATOR} -DCOMPILER=${CMAKE_CXX_COMPILER}
          -P ${CMAKE_CURRENT_LIST_DIR}/PN_installed_package.cmake)
set_tests_properties(install_without_building PROPERTIES FIXTURES_SETUP pn_installed)

set(pn_components)
foreach(component Eigen TBB)
  if(TARGET CGAL::PN_subdivision_3_${component})
    list(APPEND pn_components ${component})
  endif()
endforeach()
set(pn_libraries double,limits,recognition)
if("Eigen" IN_LIST pn_components)
  string(APPEND pn_libraries ,fitting)
endif()
list(JOIN pn_components "," pn_components)

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
  -DCOMPONENTS=${pn_components},${pn_libraries})
# an example that reads a mesh, without arguments and without the package's folder
pn_add_consumer_test(
  installed_examples ${pn_prefix}/share/PN_subdivision_3/examples/PN_subdivision_3 polyhedron
  -DCMAKE_PREFIX_PATH=${pn_prefix})
if(UNIX)
  set(pn_cgal_flags)
  get_target_property(pn_cgal_folders CGAL::CGAL INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder ${pn_cgal_folders})
    if(IS_DIRECTORY "${folder}" AND NOT folder STREQUAL "/usr/include")
      list(APPEND pn_cgal_flags -I${folder})
    endif()
  endforeach()
  add_test(
    NAME pkg_config_consumer
    COMMAND ${CMAKE_COMMAND} -DTEST=pkg_config_consumer -DPREFIX=${pn_prefix} -DFOLDER=${pn_consumer_dir}/pkg_config_consumer
            -DVERSION=${PN_subdivision_3_VERSION} -DCOMPILER=${CMAKE_CXX_COMPILER} "-DCGAL_FLAGS=${pn_cgal_flags}"
            -DSOURCE=${pn_readme_example} -P ${CMAKE_CURRENT_LIST_DIR}/PN_installed_package.cmake)
  set_tests_properties(pkg_config_consumer PROPERTIES SKIP_REGULAR_EXPRESSION "^left out: "
                                                      FIXTURES_REQUIRED pn_installed)
endif()
set_tests_properties(install_consumer installed_examples PROPERTIES FIXTURES_REQUIRED pn_installed)

if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.24)
  pn_add_consumer_test(
    subdirectory_consumer ${CMAKE_CURRENT_SOURCE_DIR}/subdirectory_consumer readme_example
    -DREADME_EXAMPLE=${pn_readme_example} -DPACKAGE_DIR=${PN_subdivision_3_SOURCE_DIR}
    -DCOMPONENTS=${pn_components})
else()
  pn_left_out(subdirectory_consumer "CMake 3.24 not found, the test of a package in a subfolder is left out")
endif()
