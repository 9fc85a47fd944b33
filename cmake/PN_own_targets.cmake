# How the package's own programs are built: examples, tests, benchmarks and the command.

if(PN_SUBDIVISION_3_DEVELOPER)
  add_library(pn_warnings INTERFACE)
  target_compile_options(pn_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Werror)
endif()

# Links a program to the package and applies the package's rules on warnings.
function(pn_own_target target)
  target_link_libraries(${target} PRIVATE CGAL::PN_subdivision_3)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(TARGET pn_warnings)
    target_link_libraries(${target} PRIVATE pn_warnings)
  endif()
endfunction()

# One program from one source file, named after the file.
function(pn_add_program source)
  get_filename_component(name ${source} NAME_WE)
  add_executable(${name} ${source})
  pn_own_target(${name})
  target_compile_definitions(${name} PRIVATE PN_DATA_DIR="${PN_subdivision_3_SOURCE_DIR}/data")
endfunction()
