# The GoogleTest programs: real meshes, the precompiled headers that they share, pn_add_test().
include(${CMAKE_CURRENT_LIST_DIR}/PN_joined_tests.cmake)

set(PN_TEST_EXTRA_MESH_DIR "" CACHE PATH "Folder with further control meshes for the tests (or empty)")

# --- real meshes: those of Debian's package libcgal-demo, unpacked into the build folder ---
set(PN_TEST_REAL_MESH_DIR ${PN_subdivision_3_BINARY_DIR}/real_meshes/data/meshes)
set(pn_real_meshes
    P cross_quad cube_poly cube_quad eight elephant fandisk mannequin-devil mesh_with_border
    nefertiti pinion quads_to_stitch torus_quad)
list(TRANSFORM pn_real_meshes PREPEND data/meshes/)
list(TRANSFORM pn_real_meshes APPEND .off)

function(pn_unpack_real_meshes)
  find_file(PN_CGAL_DATA_ARCHIVE data.tar.gz
            PATHS /usr/share/doc/libcgal-dev ${PN_subdivision_3_SOURCE_DIR}/build/debian
            NO_DEFAULT_PATH
            DOC "Archive with CGAL's data/meshes")
  if(NOT PN_CGAL_DATA_ARCHIVE)
    pn_left_out(real_meshes "CGAL's meshes not found, tests on them are left out (Debian package libcgal-demo)")
  elseif(NOT EXISTS ${PN_TEST_REAL_MESH_DIR}/torus_quad.off)
    file(MAKE_DIRECTORY ${PN_subdivision_3_BINARY_DIR}/real_meshes)
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_DATA_ARCHIVE} ${pn_real_meshes}
      WORKING_DIRECTORY ${PN_subdivision_3_BINARY_DIR}/real_meshes
      RESULT_VARIABLE failed)
    if(failed)
      pn_left_out(real_meshes "${PN_CGAL_DATA_ARCHIVE} could not be unpacked, tests on its meshes are left out")
    endif()
  endif()
endfunction()
pn_unpack_real_meshes()

# --- what every test is built with; the precompiled headers demand that it is the same for all ---
find_package(OpenMesh CONFIG QUIET)
if(NOT TARGET OpenMeshCore)
  pn_left_out(openmesh "OpenMesh not found, the tests on it are left out (Debian package libopenmesh-dev)")
endif()

# Intervals of any precision. These tests see other headers of CGAL than those that are precompiled.
set(pn_mpfi_tests test_kernels_intervals test_enclose)
find_path(PN_MPFI_INCLUDE_DIR mpfi.h)
find_library(PN_MPFI_LIBRARY mpfi)
set(pn_mpfi_found FALSE)
if(PN_MPFI_INCLUDE_DIR AND PN_MPFI_LIBRARY)
  set(pn_mpfi_found TRUE)
else()
  pn_left_out(mpfi "MPFI not found, the tests of Gmpfi are left out (Debian package libmpfi-dev)")
endif()

function(pn_test_settings target)
  pn_own_target(${target})
  pn_use_data(${target})
  target_link_libraries(${target} PRIVATE GTest::gtest)
  target_include_directories(${target} PRIVATE ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3
                             ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/support)
  target_compile_definitions(
    ${target}
    PRIVATE PN_TEST_REAL_MESH_DIR="${PN_TEST_REAL_MESH_DIR}"
            PN_TEST_EXTRA_MESH_DIR="${PN_TEST_EXTRA_MESH_DIR}")
  if(TARGET OpenMeshCore)
    target_link_libraries(${target} PRIVATE OpenMeshCore)
    target_compile_definitions(${target} PRIVATE PN_TEST_WITH_OPENMESH)
  endif()
  if(TARGET pn_subdivide)
    target_compile_definitions(${target} PRIVATE PN_SUBDIVIDE_COMMAND="$<TARGET_FILE:${pn_tested_command}>")
  endif()
  if(PN_TEST_FULL)
    target_compile_definitions(${target} PRIVATE PN_TEST_FULL)
  endif()
  # g++ takes anonymous namespaces of joined sources for those of headers, and GoogleTest's macros for an ambiguous `else`
  target_compile_options(${target} PRIVATE ${PN_TEST_OPTIMIZATION}
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage -Wno-dangling-else>)
endfunction()

# What the programs share: the headers of the package and of others; those of the command see little of CGAL. Of the schemes only
# those which most tests use, so that a change to another one compiles few tests again: what a test includes beyond that it
# compiles by itself.
set(pn_precompiled_schemes schemes/Any_scheme schemes/CatmullClark_scheme schemes/Loop_scheme)
set(pn_headers_of_command_tests <gtest/gtest.h> <algorithm> <filesystem> <fstream> <map> <sstream> <string> <vector>)
set(pn_headers_of_tests <gtest/gtest.h> <CGAL/Exact_predicates_exact_constructions_kernel.h>
    <CGAL/PN_subdivision_3/detect_creases.h> <CGAL/PN_subdivision_3/estimate_control_normals.h> <CGAL/Polyhedron_3.h>
    <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h> <CGAL/subdivision_method_3.h>)
pn_precompile_tests(pn_test_headers ${pn_headers_of_tests} INSTANCES Instances.h)
if(TARGET CGAL::PN_subdivision_3_Eigen)
  pn_precompile_tests(pn_limit_test_headers <gtest/gtest.h> <CGAL/PN_limit_surface_3/Limit_surface.h>
                      <CGAL/PN_limit_surface_3/subdivide_to_limit.h> <CGAL/PN_limit_surface_3/tessellate.h>
                      <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h> INSTANCES Limit_instances.h)
  pn_use_precompiled_in_command(pn_limit_test_headers)
endif()
set(pn_headers_of_command pn_limit_test_headers)
if(NOT TARGET pn_limit_test_headers_code)
  set(pn_headers_of_command pn_command_test_headers)
  pn_precompile_tests(pn_command_test_headers ${pn_headers_of_command_tests})
endif()

# What of the reference implementations takes long to compile, or to run without optimization; schemes by their names; main().
file(GLOB reference_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/reference/*.cpp)
if(NOT TARGET CGAL::PN_subdivision_3_Eigen)
  set(reference_sources)
endif()
add_library(pn_test_main STATIC ${CMAKE_CURRENT_SOURCE_DIR}/support/main.cpp
                                ${CMAKE_CURRENT_SOURCE_DIR}/support/scheme_named.cpp ${reference_sources})
pn_test_settings(pn_test_main)
if(NOT PN_TEST_FULL)
  set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/support/main.cpp PROPERTIES
                              COMPILE_DEFINITIONS "PN_LONG_CASES=\"${pn_long_cases}\"")
endif()
if(PN_TEST_OPTIMIZATION STREQUAL "-O0")
  set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/reference/PN_rule.cpp PROPERTIES COMPILE_OPTIONS -O1)
endif()

# pn_includes_schemes(result source): whether it includes schemes that are not precompiled.
function(pn_includes_schemes result source)
  pn_external_includes(included ${source})
  list(FILTER included INCLUDE REGEX "^schemes/")
  list(REMOVE_ITEM included ${pn_precompiled_schemes})
  set(${result} "${included}" PARENT_SCOPE)
endfunction()
foreach(header Instances.h Limit_instances.h)
  pn_includes_schemes(schemes ${CMAKE_CURRENT_SOURCE_DIR}/support/${header})
  if(schemes)
    message(FATAL_ERROR "${header} is precompiled and shall not include ${schemes}: a change to one would compile all tests again")
  endif()
endforeach()

# pn_headers_of_test(result source...): which of the precompiled headers suit sources best.
function(pn_headers_of_test result)
  set(${result} pn_test_headers PARENT_SCOPE)
  foreach(source ${ARGN})
    file(STRINGS ${source} includes REGEX "^#include .*(Feature_matrix|Limit|limit_|interpolat|tessellat)")
    if(source MATCHES "/command/")
      set(${result} ${pn_headers_of_command} PARENT_SCOPE)
    elseif((includes OR source MATCHES "/(curvature|interpolation|limit|limit_surface|tessellation)/") AND TARGET pn_limit_test_headers)
      set(${result} pn_limit_test_headers PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

# pn_add_test(name headers source...): a GoogleTest program, one entry of ctest.
function(pn_add_test name headers)
  add_executable(${name} ${ARGN})
  pn_test_settings(${name})
  add_dependencies(pn_tests ${name})
  target_link_libraries(${name} PRIVATE pn_test_main)
  if(pn_mpfi_found AND name IN_LIST pn_mpfi_tests)
    target_compile_definitions(${name} PRIVATE CGAL_USE_MPFI)
    target_include_directories(${name} SYSTEM PRIVATE ${PN_MPFI_INCLUDE_DIR})
    target_link_libraries(${name} PRIVATE ${PN_MPFI_LIBRARY})
  else()
    pn_use_precompiled(${name} ${headers})
  endif()
  add_test(NAME ${name} COMMAND ${name})
  pn_tier(${name} ${name})
endfunction()

# pn_add_test_of_library(name source library): without what others precompile.
function(pn_add_test_of_library name source library)
  add_executable(${name} ${source})
  set(libraries PN_subdivision_3_double PN_subdivision_3_limits)
  if(TARGET PN_subdivision_3_fitting)
    list(APPEND libraries PN_subdivision_3_fitting)
  endif()
  foreach(target ${name} ${libraries})
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    if(TARGET pn_warnings)
      target_link_libraries(${target} PRIVATE pn_warnings)
    endif()
  endforeach()
  target_compile_options(${name} PRIVATE ${PN_TEST_OPTIMIZATION})
  target_link_libraries(${name} PRIVATE ${library} GTest::gtest pn_test_main)
  target_include_directories(${name} PRIVATE ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3
                             ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/support)
  add_dependencies(pn_tests ${name})
  add_test(NAME ${name} COMMAND ${name})
  pn_tier(${name} ${name})
endfunction()

# --- the programs ---
file(GLOB unit_tests CONFIGURE_DEPENDS ${PN_subdivision_3_SOURCE_DIR}/test/PN_*/*/test_*.cpp)
pn_leave_out_without_eigen(unit_tests "tests")
set(groups)
foreach(unit_test ${unit_tests})
  get_filename_component(name ${unit_test} NAME_WE)
  get_filename_component(folder ${unit_test} DIRECTORY)
  get_filename_component(subject ${folder} NAME)
  if(subject STREQUAL "command" AND NOT TARGET pn_subdivide)
    continue()
  elseif(name STREQUAL "test_compiled_calls")
    pn_add_test_of_library(${name} ${unit_test} PN_subdivision_3_limits)
    target_sources(${name} PRIVATE ${folder}/compiled_calls_alone.cpp)
    set_source_files_properties(${folder}/compiled_calls_alone.cpp PROPERTIES
      COMPILE_OPTIONS "-UCGAL_PN_SUBDIVISION_3_DOUBLE;-UCGAL_PN_SUBDIVISION_3_LIMITS" SKIP_UNITY_BUILD_INCLUSION ON)
    continue()
  elseif(name STREQUAL "test_compiled_fitting")
    pn_add_test_of_library(${name} ${unit_test} PN_subdivision_3_fitting)
    target_sources(${name} PRIVATE ${folder}/compiled_fitting_alone.cpp)
    set_source_files_properties(${folder}/compiled_fitting_alone.cpp PROPERTIES
      COMPILE_OPTIONS "-UCGAL_PN_SUBDIVISION_3_DOUBLE;-UCGAL_PN_SUBDIVISION_3_LIMITS;-UCGAL_PN_SUBDIVISION_3_FITTING"
      SKIP_UNITY_BUILD_INCLUSION ON)
    continue()
  endif()
  set(kind joined)
  if(name IN_LIST pn_long_tests)
    set(kind long)
  endif()
  # test_NAME.cpp may have further sources NAME_*.cpp
  string(REGEX REPLACE "^test_" "" rest ${name})
  file(GLOB further CONFIGURE_DEPENDS ${folder}/${rest}_*.cpp)
  pn_headers_of_test(headers ${unit_test} ${further})
  pn_can_be_joined(can_be_joined ${unit_test})
  if(NOT PN_TEST_JOINED OR further OR NOT can_be_joined OR name IN_LIST pn_tests_apart)
    pn_add_test(${name} ${headers} ${unit_test} ${further})
    if(PN_TEST_JOINED AND further AND NOT name IN_LIST pn_sources_apart)
      set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 3)
    endif()
  else()
    set(group test_${kind}_${subject})
    if(headers MATCHES "_limit" AND NOT subject STREQUAL "command")
      string(APPEND group _limit)
    endif()
    pn_includes_schemes(schemes ${unit_test})
    if(schemes)
      string(APPEND group _schemes)
    endif()
    list(APPEND groups ${group})
    list(APPEND ${group} ${unit_test})
    set(headers_of_${group} ${headers})
  endif()
endforeach()
list(REMOVE_DUPLICATES groups)
foreach(group ${groups})
  pn_add_joined_tests(${group} ${headers_of_${group}} ${${group}})
endforeach()

# those of the command
get_property(programs DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
foreach(name ${programs})
  if(name MATCHES "^test_(pn_subdivide|joined_command|long_command)")
    target_link_libraries(${name} PRIVATE pn_subdivide_command pn_subdivide_one_rank nlohmann_json::nlohmann_json)
    target_compile_definitions(
      ${name} PRIVATE PN_SUBDIVIDE_MANUAL="${PN_subdivision_3_SOURCE_DIR}/src/pn_subdivide/pn_subdivide.1")
    add_dependencies(${name} ${pn_tested_command})
  endif()
endforeach()

# ranks of mpirun, and VTK, for refinement in pieces
if(TARGET test_pn_subdivide_pieces AND NOT PN_SUBDIVISION_3_WITH_MPI STREQUAL "OFF")
  find_program(PN_MPIRUN mpirun)
  if(PN_MPIRUN AND PN_MPI_FOUND)
    target_compile_definitions(test_pn_subdivide_pieces PRIVATE PN_TEST_MPIRUN="${PN_MPIRUN}"
                               PN_TEST_COMMAND_OF_RANKS="$<TARGET_FILE:pn_subdivide>")
    add_dependencies(test_pn_subdivide_pieces pn_subdivide)
  else()
    pn_left_out(ranks "MPI or mpirun not found, the tests of ranks are left out"
                " (Debian packages libopenmpi-dev, openmpi-bin)")
  endif()
endif()
if(TARGET pn_subdivide)
  find_program(PN_PYTHON_WITH_VTK python3 PATHS /usr/bin NO_DEFAULT_PATH)
  set(failed TRUE)
  if(PN_PYTHON_WITH_VTK)
    execute_process(COMMAND ${PN_PYTHON_WITH_VTK} -c "import vtkmodules.vtkIOXML, numpy"
                    RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
  endif()
  if(failed)
    pn_left_out(pvtp_in_vtk "VTK not found, the tests that read .pvtp with it are left out"
                " (Debian packages python3-vtk9, python3-numpy)")
  else()
    foreach(scheme catmull-clark modified-catmull-clark)
      add_test(NAME pvtp_in_vtk_${scheme}
               COMMAND ${PN_PYTHON_WITH_VTK} -B ${PN_subdivision_3_SOURCE_DIR}/scripts/check_pvtp.py
                       $<TARGET_FILE:pn_subdivide>
                       ${PN_subdivision_3_SOURCE_DIR}/data/meshes/mixed_borders.off
                       --scheme ${scheme} --levels 3)
    endforeach()
  endif()
endif()

# pn_unpack_cgal_examples(target): the custom mask of CGAL's manual for a test, from the archive with
# CGAL's examples. A system include folder, since it is not our code to mend.
function(pn_unpack_cgal_examples target)
  find_file(PN_CGAL_EXAMPLES_ARCHIVE examples.tar.gz
            PATHS /usr/share/doc/libcgal-dev ${PN_subdivision_3_SOURCE_DIR}/build/debian
            NO_DEFAULT_PATH
            DOC "Archive with CGAL's examples")
  set(folder examples/Subdivision_method_3)
  set(example ${folder}/Customized_subdivision.cpp)
  set(unpacked ${PN_subdivision_3_BINARY_DIR}/cgal_examples)
  if(PN_CGAL_EXAMPLES_ARCHIVE AND NOT EXISTS ${unpacked}/${example})
    file(MAKE_DIRECTORY ${unpacked})
    execute_process(COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_EXAMPLES_ARCHIVE} ${example}
                    WORKING_DIRECTORY ${unpacked})
  endif()
  if(EXISTS ${unpacked}/${example})
    target_include_directories(${target} SYSTEM PRIVATE ${unpacked}/${folder})
  else()
    message(STATUS "PN_subdivision_3: the custom mask of CGAL's manual was not found, its test is"
                   " skipped (examples.tar.gz of Debian package libcgal-dev)")
  endif()
endfunction()

# pn_change_cgal_examples(target): the examples of CGAL's Subdivision_method_3 for a test, as they are in cgal_examples and with
# this package's include and namespace in changed_cgal_examples, both in the build folder.
function(pn_change_cgal_examples target)
  set(names CatmullClark_subdivision Customized_subdivision DooSabin_subdivision Loop_subdivision Sqrt3_subdivision)
  set(folder ${PN_subdivision_3_BINARY_DIR}/cgal_examples/all)
  set(changed ${PN_subdivision_3_BINARY_DIR}/changed_cgal_examples)
  if(PN_CGAL_EXAMPLES_ARCHIVE AND NOT EXISTS ${folder})
    file(MAKE_DIRECTORY ${folder})
    execute_process(COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_EXAMPLES_ARCHIVE} examples/Subdivision_method_3
                    WORKING_DIRECTORY ${folder})
  endif()
  foreach(name ${names})
    set(example ${folder}/examples/Subdivision_method_3/${name}.cpp)
    if(NOT EXISTS ${example})
      message(STATUS "PN_subdivision_3: the examples of CGAL were not found, ${target} is skipped (examples.tar.gz of"
                     " Debian package libcgal-dev)")
      return()
    endif()
    file(READ ${example} text)
    string(REPLACE "CGAL/subdivision_method_3.h" "CGAL/PN_cgal_masks_3/Subdivision_method_3.h" text "${text}")
    string(REPLACE " Subdivision_method_3::" " PN_subdivision_3::Subdivision_method_3::" text "${text}")
    file(CONFIGURE OUTPUT ${changed}/changed/${name}.cpp CONTENT "${text}" @ONLY)
  endforeach()
  target_include_directories(${target} SYSTEM PRIVATE ${folder}/examples ${changed})
endfunction()
if(TARGET test_PN_mask_3_custom)
  pn_unpack_cgal_examples(test_PN_mask_3_custom)
  pn_change_cgal_examples(test_Subdivision_method_3_examples)
endif()

# not by find_package(): Debian's OpenSubdivConfig.cmake names a static library that is not in its package
find_path(OPENSUBDIV_INCLUDE_DIR opensubdiv/far/topologyRefiner.h)
find_library(OPENSUBDIV_CPU_LIBRARY osdCPU)
foreach(name creases_opensubdiv texture_opensubdiv)
  if(OPENSUBDIV_INCLUDE_DIR AND OPENSUBDIV_CPU_LIBRARY AND TARGET test_${name})
    target_include_directories(test_${name} SYSTEM PRIVATE ${OPENSUBDIV_INCLUDE_DIR})
    target_link_libraries(test_${name} PRIVATE ${OPENSUBDIV_CPU_LIBRARY})
    target_compile_definitions(test_${name} PRIVATE PN_TEST_WITH_OPENSUBDIV)
  elseif(TARGET test_${name})
    message(STATUS "PN_subdivision_3: OpenSubdiv not found, the comparison with it in test_${name} is"
                   " skipped (Debian package libosd-dev)")
  endif()
endforeach()
