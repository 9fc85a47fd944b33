# The programs of a user's project: the example of the README, linked to CGAL::PN_subdivision_3 alone, and one
# for each further target, which tells at compile time what it was linked to.
add_executable(readme_example ${README_EXAMPLE})
target_link_libraries(readme_example PRIVATE CGAL::PN_subdivision_3)

set(linked_source ${CMAKE_CURRENT_LIST_DIR}/linked.cpp)
function(add_linked_program name)
  add_executable(${name} ${linked_source})
  target_link_libraries(${name} PRIVATE CGAL::PN_subdivision_3)
  add_dependencies(readme_example ${name})
endfunction()

add_linked_program(linked_to_neither)
foreach(component Eigen TBB)
  if(TARGET CGAL::PN_subdivision_3_${component})
    add_linked_program(linked_to_${component})
    target_link_libraries(linked_to_${component} PRIVATE CGAL::PN_subdivision_3_${component})
    target_compile_definitions(linked_to_${component} PRIVATE EXPECTS_${component})
  endif()
endforeach()
