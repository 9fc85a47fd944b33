# cmake -DTEST=... -DFOLDER=... -DPREFIX=... -DCOMPILER=... and what else the test reads, -P: a test of the installed package.
function(run result)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE errors
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(failed)
    message(FATAL_ERROR "${ARGN}: ${log}${errors}")
  endif()
  set(${result} "${log}" PARENT_SCOPE)
endfunction()

# -DSOURCE=... -DGENERATOR=...: configures the package with the default options, installs it without building it, and looks for
# what must be there.
function(install_without_building)
  file(REMOVE_RECURSE ${PREFIX} ${FOLDER}/install_without_building)
  run(ignored ${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/install_without_building -G ${GENERATOR}
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_INSTALL_DATADIR=share -DCMAKE_INSTALL_INCLUDEDIR=include)
  run(ignored ${CMAKE_COMMAND} --install ${FOLDER}/install_without_building --prefix ${PREFIX})

  foreach(file
          include/CGAL/PN_subdivision_3.h
          include/CGAL/PN_recognition_3/internal/Shape.cpp
          share/cmake/PN_subdivision_3/PN_subdivision_3Config.cmake
          share/pkgconfig/PN_subdivision_3.pc
          share/doc/PN_subdivision_3/LICENSE.GPL
          share/doc/PN_subdivision_3/LICENSE.LGPL
          share/doc/PN_subdivision_3/README.md
          share/PN_subdivision_3/data/meshes/creature.obj
          share/PN_subdivision_3/examples/PN_subdivision_3/polyhedron.cpp)
    if(NOT EXISTS ${PREFIX}/${file})
      message(FATAL_ERROR "${PREFIX}/${file} has not been installed")
    endif()
  endforeach()

  # what is installed includes nothing that is not
  file(GLOB_RECURSE sources ${PREFIX}/include/*.h ${PREFIX}/share/*.h ${PREFIX}/share/*.cpp)
  file(GLOB_RECURSE headers RELATIVE ${SOURCE}/test_support ${SOURCE}/test_support/*.h)
  foreach(source ${sources})
    file(STRINGS ${source} includes REGEX "^ *# *include \"")
    foreach(header ${headers})
      if("${includes}" MATCHES "\"${header}\"")
        message(FATAL_ERROR "${source} includes ${header} of test_support/, which is not installed")
      endif()
    endforeach()
  endforeach()
endfunction()

# -DVERSION=... -DCGAL_FLAGS=... -DSOURCE=...: moves what is installed to another folder, and builds a program there with the
# options that pkg-config tells.
function(pkg_config_consumer)
  find_program(PKG_CONFIG pkg-config)
  if(NOT PKG_CONFIG)
    message("left out: pkg-config is missing (Debian package pkgconf)")
    return()
  endif()
  file(REMOVE_RECURSE ${FOLDER})
  file(COPY ${PREFIX}/include ${PREFIX}/share DESTINATION ${FOLDER}/moved)
  set(ENV{PKG_CONFIG_PATH} ${FOLDER}/moved/share/pkgconfig)
  run(version ${PKG_CONFIG} --modversion PN_subdivision_3)
  if(NOT version STREQUAL VERSION)
    message(FATAL_ERROR "pkg-config tells the version ${version}, not ${VERSION}.")
  endif()
  run(cflags ${PKG_CONFIG} --cflags PN_subdivision_3)
  run(libs ${PKG_CONFIG} --libs PN_subdivision_3)
  separate_arguments(cflags UNIX_COMMAND "${cflags}")
  separate_arguments(libs UNIX_COMMAND "${libs}")
  run(ignored ${COMPILER} -std=c++17 ${CGAL_FLAGS} ${cflags} ${SOURCE} -o ${FOLDER}/program ${libs})
  run(output ${CMAKE_COMMAND} -E chdir ${FOLDER} ./program)
  message("${output}")
endfunction()

cmake_language(CALL ${TEST})
