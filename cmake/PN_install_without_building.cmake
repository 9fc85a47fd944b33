# cmake -DSOURCE=... -DFOLDER=... -DPREFIX=... -DGENERATOR=... -DCOMPILER=... -P: configures the package
# with the default options, installs it without building it, and looks for what must be there.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE log ERROR_VARIABLE log)
  if(failed)
    message(FATAL_ERROR "${log}")
  endif()
endfunction()

file(REMOVE_RECURSE ${PREFIX} ${FOLDER}/install_without_building)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/install_without_building -G ${GENERATOR}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_INSTALL_DATADIR=share -DCMAKE_INSTALL_INCLUDEDIR=include)
run(${CMAKE_COMMAND} --install ${FOLDER}/install_without_building --prefix ${PREFIX})

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
