# What sources of the package include, read from their texts. An include inside #if is indented
# (clang-format) and does not count: such a source does without.

set(pn_include_folders ${PN_subdivision_3_SOURCE_DIR}/include ${PN_subdivision_3_SOURCE_DIR}/test_support
                       ${PN_subdivision_3_SOURCE_DIR}/src/pn_subdivide
                       ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3
                       ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/support
                       ${PN_subdivision_3_SOURCE_DIR}/examples/PN_subdivision_3)

# pn_external_includes(result source): the headers of others that a source of the package includes,
# directly or by headers of the package; and those of test_support/, as test_support/NAME.
function(pn_external_includes result source)
  get_property(known GLOBAL PROPERTY pn_external_includes_of_${source} SET)
  if(NOT known)
    set_property(GLOBAL PROPERTY pn_external_includes_of_${source} "") # ends a cycle
    set(external)
    get_filename_component(folder ${source} DIRECTORY)
    file(STRINGS ${source} lines REGEX "^#include [<\"]")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include [<\"]([^>\"]*)[>\"].*" "\\1" name "${line}")
      set(own)
      foreach(candidate ${folder} ${pn_include_folders})
        if(NOT own AND EXISTS ${candidate}/${name})
          get_filename_component(own ${candidate}/${name} ABSOLUTE)
        endif()
      endforeach()
      if(own)
        pn_external_includes(further ${own})
        list(APPEND external ${further})
        if(own MATCHES "/test_support/")
          list(APPEND external test_support/${name})
        endif()
      else()
        list(APPEND external ${name})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES external)
    set_property(GLOBAL PROPERTY pn_external_includes_of_${source} "${external}")
  endif()
  get_property(external GLOBAL PROPERTY pn_external_includes_of_${source})
  set(${result} ${external} PARENT_SCOPE)
endfunction()

# pn_leave_out_without_eigen(list what): removes from a list of sources those that need Eigen if it was
# not found, and says so.
function(pn_leave_out_without_eigen list what)
  if(TARGET CGAL::PN_subdivision_3_Eigen)
    return()
  endif()
  set(left_out)
  foreach(source IN LISTS ${list})
    pn_external_includes(external ${source})
    if(external MATCHES "(^|;)Eigen/")
      get_filename_component(name ${source} NAME_WE)
      list(APPEND left_out ${name})
      list(REMOVE_ITEM ${list} ${source})
    endif()
  endforeach()
  if(left_out)
    list(JOIN left_out ", " names)
    message(STATUS "PN_subdivision_3: without Eigen these ${what} are left out: ${names}")
  endif()
  set(${list} ${${list}} PARENT_SCOPE)
endfunction()
