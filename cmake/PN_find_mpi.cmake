# MPI, for the command and its tests: PN_MPI_FOUND, and then the target MPI::MPI_CXX.
#
# Some packages bring the compiler wrapper without the headers (Debian's openmpi-bin). CMake's FindMPI then ends
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
