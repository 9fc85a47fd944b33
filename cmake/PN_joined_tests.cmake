# Several test sources as one program: what they instantiate alike is compiled once, which takes less than half the time.
option(PN_TEST_JOINED "The unit tests of a subject are compiled as one source, or a few (CMake 3.18 or newer)" OFF)
set(PN_TESTS_IN_A_SOURCE 5) # so that none takes more than a minute and 1.8 GB
# with settings or an operator new of their own, with names that headers of others have, too, or long
set(pn_tests_apart
    test_PN_mask_3_custom test_any_scheme test_Subdivision_method_3_examples test_coherent_normals test_creased_refiner
    test_enclose test_estimate_control_normals test_estimate_curvature test_failures test_kernels_exact
    test_kernels_floating test_kernels_intervals test_limit_creases test_limit_input test_matrix_of_features
    test_mesh_types test_modified_schemes_numbers test_normal_guards test_pieces test_reciprocal_normals
    test_strong_guarantee)
# several sources of one test, with names that are not the same in all of them
set(pn_sources_apart test_limit_surface test_tessellate)

# Includes that depend on macros have to stay where they are; and a header of CGAL without include guard may be included once.
function(pn_can_be_joined result source)
  file(STRINGS ${source} directives REGEX "^#")
  set(has_other FALSE)
  file(STRINGS ${source} opened REGEX "^namespace [A-Za-z_]+ {") # that others open, too
  set(can_be_joined TRUE)
  if(opened)
    set(can_be_joined FALSE)
  endif()
  foreach(directive IN LISTS directives)
    if(NOT directive MATCHES "^# *include")
      set(has_other TRUE)
    elseif(has_other OR directive MATCHES "CGAL/Exact_(rational|integer)\\.h")
      set(can_be_joined FALSE)
    endif()
  endforeach()
  set(${result} ${can_be_joined} PARENT_SCOPE)
endfunction()

# pn_write_joined(file source...): all headers first, then the sources, whose own includes do nothing any more, each in a
# namespace of its own.
function(pn_write_joined file)
  set(headers)
  set(content)
  foreach(source IN LISTS ARGN)
    file(STRINGS ${source} includes REGEX "^# *include")
    list(APPEND headers ${includes})
    get_filename_component(name ${source} NAME_WE)
    string(APPEND content "namespace of_${name} {\n#include \"${source}\"\n}\n")
  endforeach()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "\n" headers)
  file(CONFIGURE OUTPUT ${file} CONTENT "${headers}\n${content}" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN}) # for their headers
endfunction()

# pn_add_joined_tests(name headers source...): the programs NAME_1, NAME_2, ... of these sources.
function(pn_add_joined_tests name headers)
  set(number 0)
  set(sources ${ARGN})
  list(LENGTH sources left)
  while(left GREATER 0)
    math(EXPR number "${number} + 1")
    list(SUBLIST sources 0 ${PN_TESTS_IN_A_SOURCE} some)
    list(REMOVE_ITEM sources ${some})
    list(LENGTH sources left)
    set(joined ${CMAKE_CURRENT_BINARY_DIR}/joined/${name}_${number}.cpp)
    pn_write_joined(${joined} ${some})
    list(GET some 0 first)
    get_filename_component(folder ${first} DIRECTORY)
    pn_add_test(${name}_${number} ${headers} ${joined})
    target_include_directories(${name}_${number} PRIVATE ${folder})
  endwhile()
endfunction()

# --- precompiled headers of tests, and the code of what they instantiate ---
# pn_precompile_tests(name header... [INSTANCES header]): with clang++ the precompiled header leaves the code of its functions,
# those that INSTANCES names for many tests among them, to an object of its own. It is linked to all that use it, which then
# compile in half the time. It has the inline functions of GoogleTest, too.
function(pn_precompile_tests name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "INSTANCES" "")
  set(with_code FALSE)
  if(arg_INSTANCES AND PN_TEST_OPTIMIZATION STREQUAL "-O0" AND CMAKE_GENERATOR MATCHES "Ninja" AND NOT CMAKE_DISABLE_PRECOMPILE_HEADERS
     AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    set(with_code TRUE)
    list(APPEND arg_UNPARSED_ARGUMENTS ${CMAKE_CURRENT_SOURCE_DIR}/support/${arg_INSTANCES})
  endif()
  pn_precompile(${name} ${arg_UNPARSED_ARGUMENTS})
  pn_test_settings(${name})
  if(with_code)
    target_compile_options(${name} PRIVATE "SHELL:-Xclang -fmodules-codegen")
    set(precompiled ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/cmake_pch.hxx.pch)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}_code.o)
    add_custom_command(OUTPUT ${object} COMMAND ${CMAKE_CXX_COMPILER} -O0 -c ${precompiled} -o ${object}
                       DEPENDS ${precompiled} COMMENT "Building code of ${name}" VERBATIM)
    add_library(${name}_code STATIC ${object})
    set_target_properties(${name}_code PROPERTIES LINKER_LANGUAGE CXX)
    target_link_libraries(${name}_code INTERFACE GTest::gtest)
  endif()
endfunction()

function(pn_use_precompiled target name)
  target_precompile_headers(${target} REUSE_FROM ${name})
  if(TARGET ${name}_code)
    target_link_libraries(${target} PRIVATE ${name}_code)
  endif()
endfunction()

# The command for tests: its objects instantiate what tests of limits do. (By g++, and optimized, it is compiled as it is shipped.)
function(pn_use_precompiled_in_command name)
  if(NOT TARGET ${name}_code OR NOT TARGET pn_subdivide OR CMAKE_VERSION VERSION_LESS 3.18)
    return()
  endif()
  foreach(target pn_subdivide_command pn_subdivide_io pn_subdivide ${pn_tested_command})
    set_property(TARGET ${target} PROPERTY PRECOMPILE_HEADERS)
    pn_use_precompiled(${target} ${name})
  endforeach()
endfunction()
