# What the headers of PN_subdivision_3 need, for a build from its sources; an installed package finds
# its dependencies in PN_subdivision_3Config.cmake. CGAL brings the Boost headers. Eigen and TBB are
# optional.

# Everything found here is made visible in the whole project, as CGAL's own target is: otherwise a
# project that takes the package by add_subdirectory() could not link it. Needs CMake 3.24; with an
# older one such a project calls find_package() for CGAL, Eigen3 and TBB itself.
set(_pn_targets_global ${CMAKE_FIND_PACKAGE_TARGETS_GLOBAL})
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ON)

if(NOT TARGET CGAL::CGAL)
  # CGAL 6.0 asks for Boost in the old way, of which CMake 3.30 and newer warn
  if(NOT DEFINED CMAKE_POLICY_DEFAULT_CMP0167)
    set(CMAKE_POLICY_DEFAULT_CMP0167 OLD)
  endif()
  find_package(CGAL 5.5 QUIET)
endif()
if(NOT TARGET CGAL::CGAL)
  message(FATAL_ERROR "PN_subdivision_3 needs CGAL 5.5 or newer, which was not found"
                      " (Debian package libcgal-dev; -DCGAL_DIR=... names the folder of CGALConfig.cmake).")
endif()

if(PN_SUBDIVISION_3_WITH_EIGEN)
  if(NOT TARGET Eigen3::Eigen)
    find_package(Eigen3 3.3 CONFIG QUIET)
  endif()
  if(NOT TARGET Eigen3::Eigen)
    pn_missing(EIGEN "Eigen not found, curvatures and interpolation are left out\
 (Debian package libeigen3-dev)")
  endif()
endif()

if(PN_SUBDIVISION_3_WITH_TBB)
  if(NOT TARGET TBB::tbb)
    find_package(TBB CONFIG QUIET)
  endif()
  if(TARGET TBB::tbb AND NOT TARGET CGAL::TBB_support)
    set(TBB_FOUND TRUE)
    include(CGAL_TBB_support)
    set_target_properties(CGAL::TBB_support PROPERTIES IMPORTED_GLOBAL TRUE)
  endif()
  if(NOT TARGET CGAL::TBB_support)
    pn_missing(TBB "TBB not found, Parallel_tag is left out (Debian package libtbb-dev)")
  endif()
endif()

set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL ${_pn_targets_global})
unset(_pn_targets_global)
