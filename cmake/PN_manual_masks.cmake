# pn_unpack_cgal_examples(target): the custom mask of CGAL's manual for a test, from the archive with
# CGAL's examples. A system include folder, since it is not our code to mend.
function(pn_unpack_cgal_examples target)
  find_file(PN_CGAL_EXAMPLES_ARCHIVE examples.tar.gz
            PATHS /usr/share/doc/libcgal-dev ${PN_subdivision_3_SOURCE_DIR}/build/debian
            NO_DEFAULT_PATH
            DOC "Archive with CGAL's examples")
  set(folder examples/Subdivision_method_3)
  set(example ${folder}/Customized_subdivision.cpp)
  set(unpacked ${PN_subdivision_3_BINARY_DIR}/cgal_examples)
  if(PN_CGAL_EXAMPLES_ARCHIVE AND NOT EXISTS ${unpacked}/${example})
    file(MAKE_DIRECTORY ${unpacked})
    execute_process(COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_EXAMPLES_ARCHIVE} ${example}
                    WORKING_DIRECTORY ${unpacked})
  endif()
  if(EXISTS ${unpacked}/${example})
    target_include_directories(${target} SYSTEM PRIVATE ${unpacked}/${folder})
  else()
    message(STATUS "PN_subdivision_3: the custom mask of CGAL's manual was not found, its test is"
                   " skipped (examples.tar.gz of Debian package libcgal-dev)")
  endif()
endfunction()

# pn_change_cgal_examples(target): the examples of CGAL's Subdivision_method_3 for a test, as they are in cgal_examples and with
# this package's include and namespace in changed_cgal_examples, both in the build folder.
function(pn_change_cgal_examples target)
  set(names CatmullClark_subdivision Customized_subdivision DooSabin_subdivision Loop_subdivision Sqrt3_subdivision)
  set(folder ${PN_subdivision_3_BINARY_DIR}/cgal_examples/all)
  set(changed ${PN_subdivision_3_BINARY_DIR}/changed_cgal_examples)
  if(PN_CGAL_EXAMPLES_ARCHIVE AND NOT EXISTS ${folder})
    file(MAKE_DIRECTORY ${folder})
    execute_process(COMMAND ${CMAKE_COMMAND} -E tar xzf ${PN_CGAL_EXAMPLES_ARCHIVE} examples/Subdivision_method_3
                    WORKING_DIRECTORY ${folder})
  endif()
  foreach(name ${names})
    set(example ${folder}/examples/Subdivision_method_3/${name}.cpp)
    if(NOT EXISTS ${example})
      message(STATUS "PN_subdivision_3: the examples of CGAL were not found, ${target} is skipped (examples.tar.gz of"
                     " Debian package libcgal-dev)")
      return()
    endif()
    file(READ ${example} text)
    string(REPLACE "CGAL/subdivision_method_3.h" "CGAL/PN_cgal_masks_3/Subdivision_method_3.h" text "${text}")
    string(REPLACE " Subdivision_method_3::" " PN_subdivision_3::Subdivision_method_3::" text "${text}")
    file(CONFIGURE OUTPUT ${changed}/changed/${name}.cpp CONTENT "${text}" @ONLY)
  endforeach()
  target_include_directories(${target} SYSTEM PRIVATE ${folder}/examples ${changed})
endfunction()
