# What PN_subdivision_3 needs and may use, for a build from its sources; an installed package finds its dependencies in
# PN_subdivision_3Config.cmake. CGAL brings the Boost headers. Of what is optional PN_SUBDIVISION_3_WITH_... is OFF, ON (an
# error where it is missing) or AUTO (taken where it is found).

# pn_choice(name default meaning): the option of this name.
function(pn_choice name default meaning)
  set(option PN_SUBDIVISION_3_WITH_${name})
  set(${option} ${default} CACHE STRING "${meaning}: OFF, ON, or AUTO (where it is found)")
  set_property(CACHE ${option} PROPERTY STRINGS OFF ON AUTO)
  string(TOUPPER "${${option}}" value)
  if(value MATCHES "^(1|Y|YES|TRUE)$")
    set(value ON)
  elseif(value MATCHES "^(0|N|NO|FALSE)?$")
    set(value OFF)
  elseif(NOT value MATCHES "^(OFF|ON|AUTO)$")
    message(FATAL_ERROR "${option} is '${${option}}', but must be OFF, ON or AUTO.")
  endif()
  set(${option} ${value} PARENT_SCOPE)
endfunction()

# pn_missing(name sentence): says that something is left out, or ends if it was asked for.
function(pn_missing name sentence)
  if(PN_SUBDIVISION_3_WITH_${name} STREQUAL "AUTO")
    message(STATUS "PN_subdivision_3: ${sentence}")
  else()
    message(FATAL_ERROR "PN_subdivision_3: ${sentence}; PN_SUBDIVISION_3_WITH_${name} is ON:"
                        " AUTO or OFF does without it.")
  endif()
endfunction()

pn_choice(EIGEN AUTO "Use Eigen: curvatures, interpolation")
pn_choice(TBB AUTO "Use TBB: threads, CGAL::Parallel_tag")
pn_choice(MPI OFF "Let pn_subdivide share its work among the ranks of mpirun")

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

# MPI: some packages bring the compiler wrapper without the headers (Debian's openmpi-bin). CMake's FindMPI then ends
# the configuration, whether or not MPI is required, because the wrapper names a folder that does not exist. So the
# wrapper is asked here before.

# pn_mpi_include_folders(result wrapper): the include folders that a compiler wrapper names.
function(pn_mpi_include_folders result wrapper)
  set(folders)
  foreach(option -showme:incdirs -show -compile_info) # Open MPI; MPICH and its relatives
    execute_process(COMMAND ${wrapper} ${option} RESULT_VARIABLE failed OUTPUT_VARIABLE words
                    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
    if(failed)
      continue()
    endif()
    separate_arguments(words NATIVE_COMMAND "${words}")
    if(option STREQUAL "-showme:incdirs")
      set(folders ${words})
    else()
      string(REGEX REPLACE "(^|;)(-I|-isystem);" "\\1-I" words "${words}")
      list(FILTER words INCLUDE REGEX "^-I")
      list(TRANSFORM words REPLACE "^-I" "" OUTPUT_VARIABLE folders)
    endif()
    break()
  endforeach()
  set(${result} "${folders}" PARENT_SCOPE)
endfunction()

# pn_why_no_mpi(result): why there is no use in asking FindMPI, or nothing.
function(pn_why_no_mpi result)
  set(reason)
  find_program(MPI_CXX_COMPILER NAMES mpicxx mpic++ mpiCC HINTS ${MPI_HOME} ENV MPI_HOME PATH_SUFFIXES bin
               DOC "MPI compiler for CXX")
  if(MPI_CXX_COMPILER)
    pn_mpi_include_folders(folders ${MPI_CXX_COMPILER})
    set(has_header FALSE)
    foreach(folder IN LISTS folders CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
      if(NOT IS_DIRECTORY "${folder}" AND NOT reason)
        set(reason "${MPI_CXX_COMPILER} names ${folder}, which does not exist")
      elseif(EXISTS "${folder}/mpi.h")
        set(has_header TRUE)
      endif()
    endforeach()
    if(folders AND NOT has_header AND NOT reason)
      list(JOIN folders ", " folders)
      set(reason "there is no mpi.h where ${MPI_CXX_COMPILER} looks for it, in ${folders}")
    endif()
  endif()
  set(${result} "${reason}" PARENT_SCOPE)
endfunction()

# pn_find_mpi(): MPI, for the command and its tests: PN_MPI_FOUND, and then the target MPI::MPI_CXX.
macro(pn_find_mpi)
  set(PN_MPI_FOUND FALSE)
  if(PN_SUBDIVISION_3_WITH_MPI)
    pn_why_no_mpi(pn_reason)
    if(NOT pn_reason)
      find_package(MPI QUIET COMPONENTS CXX)
      set(PN_MPI_FOUND ${MPI_CXX_FOUND})
      set(pn_reason "no MPI for C++ was found")
    endif()
    if(NOT PN_MPI_FOUND)
      pn_missing(MPI "MPI is left out, pn_subdivide does not start with mpirun:\
   ${pn_reason} (Debian package libopenmpi-dev)")
    endif()
  endif()
endmacro()
