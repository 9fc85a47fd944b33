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
