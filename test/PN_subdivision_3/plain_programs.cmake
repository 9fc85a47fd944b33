# The plain programs of a package's tests by themselves, as CGAL's own harness builds them.
find_package(CGAL REQUIRED)
if(EXISTS ${CMAKE_CURRENT_LIST_DIR}/../../include/CGAL/PN_subdivision_3.h)
  include_directories(BEFORE ${CMAKE_CURRENT_LIST_DIR}/../../include)
endif()
include_directories(${CMAKE_CURRENT_LIST_DIR}) # what tests share
file(GLOB smoke_tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/smoke_*.cpp)
foreach(smoke_test ${smoke_tests})
  create_single_source_cgal_program(${smoke_test})
  get_filename_component(name ${smoke_test} NAME_WE)
  target_compile_features(${name} PRIVATE cxx_std_17)
endforeach()
message(STATUS "${PROJECT_NAME}: the plain programs; configure the package's root folder for all tests")
