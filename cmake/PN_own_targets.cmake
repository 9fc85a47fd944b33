# How the package's own programs are built: examples, tests, benchmarks and the command.
include(${CMAKE_CURRENT_LIST_DIR}/PN_includes.cmake)

set(pn_default_optimization "")
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set(pn_default_optimization -O1)
endif()
set(PN_TEST_OPTIMIZATION "${pn_default_optimization}" CACHE STRING
    "Optimization of tests, and of examples that measure nothing (empty: the build type's)")

if(PN_SUBDIVISION_3_DEVELOPER)
  add_library(pn_warnings INTERFACE)
  target_compile_options(pn_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror)
  find_program(PN_LLD ld.lld) # takes a sixth of the time
  if(PN_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_link_options(pn_warnings INTERFACE -fuse-ld=lld)
  endif()
endif()

# Links a program to the package, with all that this build uses and what is only for its own programs (test_support/), and
# applies the package's rules on warnings.
function(pn_own_target target)
  foreach(library PN_subdivision_3 PN_subdivision_3_Eigen PN_subdivision_3_TBB)
    if(TARGET CGAL::${library})
      target_link_libraries(${target} PRIVATE CGAL::${library})
    endif()
  endforeach()
  target_include_directories(${target} PRIVATE ${PN_subdivision_3_SOURCE_DIR}/test_support)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(TARGET pn_warnings)
    target_link_libraries(${target} PRIVATE pn_warnings)
  endif()
endfunction()

# The meshes of data/: for CGAL::data_file_path("meshes/NAME"), and for tests their folder.
function(pn_use_data target)
  set(data ${PN_subdivision_3_SOURCE_DIR}/data)
  target_compile_definitions(${target} PRIVATE CGAL_DATA_DIR="${data}" PN_DATA_DIR="${data}/meshes")
endfunction()

# One program from one source file, named after the file.
function(pn_add_program source)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  pn_own_target(${name})
  pn_use_data(${name})
endfunction()

# pn_precompile(name header...): headers that the targets of one kind share; the targets, whose options
# must be those of the first, take them with target_precompile_headers(... REUSE_FROM name).
set(pn_empty_source ${PN_subdivision_3_BINARY_DIR}/generated/empty.cpp)
file(GENERATE OUTPUT ${pn_empty_source} CONTENT "")
function(pn_precompile name)
  add_library(${name} OBJECT ${pn_empty_source})
  target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()
