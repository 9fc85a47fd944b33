# pn_add_test(), the precompiled headers the tests share, real meshes, and headers compiled alone.

set(PN_TEST_OPTIMIZATION "" CACHE STRING
    "Optimization level of the tests, -O0 for instance (empty: the one of the build type)")
set(PN_TEST_EXTRA_MESH_DIR ${PN_subdivision_3_SOURCE_DIR}/../shared/data CACHE PATH
    "Folder with further control meshes for the tests (may be missing)")

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
    message(STATUS "PN_subdivision_3: CGAL's meshes not found, tests on them are skipped"
                   " (Debian package libcgal-demo)")
  elseif(NOT EXISTS ${PN_TEST_REAL_MESH_DIR}/torus_quad.off)
    file(MAKE_DIRECTORY ${PN_subdivision_3_BINARY_DIR}/real_meshes)
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_DATA_ARCHIVE} ${pn_real_meshes}
      WORKING_DIRECTORY ${PN_subdivision_3_BINARY_DIR}/real_meshes
      RESULT_VARIABLE failed)
    if(failed)
      message(WARNING "PN_subdivision_3: ${PN_CGAL_DATA_ARCHIVE} could not be unpacked,"
                      " tests on real meshes are skipped")
    endif()
  endif()
endfunction()
pn_unpack_real_meshes()

# --- what every test is built with; the precompiled headers demand that it is the same for all ---
find_package(OpenMesh CONFIG QUIET)
if(NOT TARGET OpenMeshCore)
  message(STATUS "PN_subdivision_3: OpenMesh not found, tests on it are left out"
                 " (Debian package libopenmesh-dev)")
endif()

function(pn_test_settings target)
  pn_own_target(${target})
  target_link_libraries(${target} PRIVATE GTest::gtest)
  target_include_directories(${target} PRIVATE ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3
                             ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/support)
  target_compile_definitions(
    ${target}
    PRIVATE PN_DATA_DIR="${PN_subdivision_3_SOURCE_DIR}/data"
            PN_TEST_REAL_MESH_DIR="${PN_TEST_REAL_MESH_DIR}"
            PN_TEST_EXTRA_MESH_DIR="${PN_TEST_EXTRA_MESH_DIR}")
  if(TARGET OpenMeshCore)
    target_link_libraries(${target} PRIVATE OpenMeshCore)
    target_compile_definitions(${target} PRIVATE PN_TEST_WITH_OPENMESH)
  endif()
  if(TARGET pn_subdivide)
    target_compile_definitions(${target} PRIVATE PN_SUBDIVIDE_COMMAND="$<TARGET_FILE:pn_subdivide>")
  endif()
  target_compile_options(${target} PRIVATE ${PN_TEST_OPTIMIZATION})
endfunction()

set(pn_empty_source ${PN_subdivision_3_BINARY_DIR}/generated/empty.cpp)
file(GENERATE OUTPUT ${pn_empty_source} CONTENT "")
add_library(pn_test_headers OBJECT ${pn_empty_source})
pn_test_settings(pn_test_headers)
target_precompile_headers(
  pn_test_headers PRIVATE <gtest/gtest.h> <CGAL/Exact_predicates_exact_constructions_kernel.h>
  <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Polyhedron_3.h>
  <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h> <CGAL/subdivision_method_3.h>)

# pn_add_test(name source... [WHOLE]): a GoogleTest program. Each of its tests is an entry of its own
# in ctest; with WHOLE the program is one entry (for costly set-up that its tests share).
function(pn_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WHOLE" "" "")
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  pn_test_settings(${name})
  target_link_libraries(${name} PRIVATE GTest::gtest_main)
  target_precompile_headers(${name} REUSE_FROM pn_test_headers)
  if(arg_WHOLE)
    add_test(NAME ${name} COMMAND ${name})
  else()
    gtest_discover_tests(${name} TEST_PREFIX ${name}. NO_PRETTY_TYPES DISCOVERY_TIMEOUT 60)
  endif()
endfunction()

# --- every header compiles alone: one generated source per header ---
function(pn_check_headers_alone)
  set(include_dir ${PN_subdivision_3_SOURCE_DIR}/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE ${include_dir} ${include_dir}/*.h)
  set(sources)
  foreach(header ${headers})
    string(MAKE_C_IDENTIFIER ${header} name)
    set(source ${PN_subdivision_3_BINARY_DIR}/generated/headers_alone/${name}.cpp)
    file(GENERATE OUTPUT ${source} CONTENT "#include <${header}>\n#include <${header}>\n")
    list(APPEND sources ${source})
  endforeach()
  if(sources)
    add_library(pn_headers_alone OBJECT ${sources})
    pn_own_target(pn_headers_alone)
    target_compile_options(pn_headers_alone PRIVATE -O0)
  endif()
endfunction()
