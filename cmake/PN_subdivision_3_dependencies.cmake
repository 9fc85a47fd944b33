# What the headers of PN_subdivision_3 need; read by the build tree and by the installed package.
# CGAL brings the Boost headers. Eigen and TBB are optional.

option(PN_SUBDIVISION_3_WITH_TBB "Use TBB for Parallel_tag where it is found" ON)

# Everything found here is made visible in the whole project, as CGAL's own target is: otherwise a
# project that takes the package by add_subdirectory() could not link it. Needs CMake 3.24; with an
# older one such a project calls find_package() for CGAL, Eigen3 and TBB itself.
set(_pn_targets_global ${CMAKE_FIND_PACKAGE_TARGETS_GLOBAL})
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

if(NOT TARGET CGAL::CGAL)
  find_package(CGAL 5.5 QUIET)
endif()
if(NOT TARGET Eigen3::Eigen)
  find_package(Eigen3 3.3 CONFIG QUIET)
endif()
if(PN_SUBDIVISION_3_WITH_TBB AND NOT TARGET TBB::tbb)
  find_package(TBB CONFIG QUIET)
endif()

set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ${_pn_targets_global})
unset(_pn_targets_global)

if(PN_SUBDIVISION_3_WITH_TBB AND TARGET TBB::tbb AND NOT TARGET CGAL::TBB_support)
  set(TBB_FOUND TRUE)
  include(CGAL_TBB_support)
  set_target_properties(CGAL::TBB_support PROPERTIES IMPORTED_GLOBAL TRUE)
endif()

function(pn_subdivision_3_link_dependencies target)
  target_compile_features(${target} INTERFACE cxx_std_17)
  target_link_libraries(${target} INTERFACE CGAL::CGAL)
  if(TARGET Eigen3::Eigen)
    target_link_libraries(${target} INTERFACE Eigen3::Eigen)
  endif()
  if(PN_SUBDIVISION_3_WITH_TBB AND TARGET CGAL::TBB_support)
    target_link_libraries(${target} INTERFACE CGAL::TBB_support)
  endif()
endfunction()
