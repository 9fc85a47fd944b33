# How the package's own programs are built: examples, tests, benchmarks and the command.

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

# --- what sources of the package include, read from their texts ---
# An include inside #if is indented (clang-format) and does not count: such a source does without.
set(pn_include_folders ${PN_subdivision_3_SOURCE_DIR}/include ${PN_subdivision_3_SOURCE_DIR}/test_support
                       ${PN_subdivision_3_SOURCE_DIR}/src/pn_subdivide
                       ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3
                       ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/support
                       ${PN_subdivision_3_SOURCE_DIR}/examples/PN_subdivision_3)

# pn_external_includes(result source): the headers of others that a source of the package includes,
# directly or by headers of the package; those of test_support/, as test_support/NAME; and of schemes, as schemes/NAME.
function(pn_external_includes result source)
  get_property(known GLOBAL PROPERTY pn_external_includes_of_${source} SET)
  if(NOT known)
    set_property(GLOBAL PROPERTY pn_external_includes_of_${source} "") # ends a cycle
    set(external)
    get_filename_component(folder ${source} DIRECTORY)
    file(STRINGS ${source} lines REGEX "^#include [<\"]")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include [<\"]([^>\"]*)[>\"].*" "\\1" name "${line}")
      set(own)
      foreach(candidate ${folder} ${pn_include_folders})
        if(NOT own AND EXISTS ${candidate}/${name})
          get_filename_component(own ${candidate}/${name} ABSOLUTE)
        endif()
      endforeach()
      if(own)
        pn_external_includes(further ${own})
        list(APPEND external ${further})
        if(own MATCHES "/test_support/")
          list(APPEND external test_support/${name})
        elseif(own MATCHES "/PN_subdivision_3/(schemes/[A-Za-z0-9_]+_schemes?)\\.h$")
          list(APPEND external ${CMAKE_MATCH_1})
        endif()
      else()
        list(APPEND external ${name})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES external)
    set_property(GLOBAL PROPERTY pn_external_includes_of_${source} "${external}")
  endif()
  get_property(external GLOBAL PROPERTY pn_external_includes_of_${source})
  set(${result} ${external} PARENT_SCOPE)
endfunction()

# pn_leave_out_without_eigen(list what): removes from a list of sources those that need Eigen if it was
# not found, and says so.
function(pn_leave_out_without_eigen list what)
  if(TARGET CGAL::PN_subdivision_3_Eigen)
    return()
  endif()
  set(left_out)
  foreach(source IN LISTS ${list})
    pn_external_includes(external ${source})
    if(external MATCHES "(^|;)Eigen/")
      get_filename_component(name ${source} NAME_WE)
      list(APPEND left_out ${name})
      list(REMOVE_ITEM ${list} ${source})
    endif()
  endforeach()
  if(left_out)
    list(JOIN left_out ", " names)
    message(STATUS "PN_subdivision_3: without Eigen these ${what} are left out: ${names}")
  endif()
  set(${list} ${${list}} PARENT_SCOPE)
endfunction()
