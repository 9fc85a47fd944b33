# Precompiled headers of tests, and the code of what they instantiate.

# pn_precompile_tests(name header... [INSTANCES header]): with clang++ the precompiled header leaves the code of its functions,
# those that INSTANCES names for many tests among them, to an object of its own. It is optimized, and linked to all that use it,
# which then compile and run in half the time.
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
  endif()
endfunction()

function(pn_use_precompiled target name)
  target_precompile_headers(${target} REUSE_FROM ${name})
  if(TARGET ${name}_code)
    target_link_libraries(${target} PRIVATE ${name}_code)
  endif()
endfunction()
