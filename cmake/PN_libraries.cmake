# Static libraries for programs that shall not compile everything themselves: CGAL::PN_subdivision_3_double has the usual calls of
# subdivide() (internal/calls/Mesh_subdivision.h) and, for every mesh and kernel of double, what is computed of levels
# (internal/meshes/compiled_levels.h); CGAL::PN_subdivision_3_limits their limits and tessellation
# (PN_limit_surface_3/internal/limit/limits_at_slots.h), CGAL::PN_subdivision_3_fitting interpolation,
# CGAL::PN_subdivision_3_recognition recognition. They are made where they are used, by the compiler and with the options of that
# project, when something is first linked to them.
# Reads _pn_package, the target of the package, and _pn_sources, the folder of their sources. No function: an installed package
# leaves none behind.
# What the sources of a library read takes as long as what they instantiate: it is read once.
set(_pn_read_double <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h>
    <CGAL/PN_subdivision_3/subdivide.h>)
set(_pn_read_limits <CGAL/PN_limit_surface_3/internal/limit/limits_at_slots.h>
    <CGAL/PN_limit_surface_3/internal/limit_surface/Surface_evaluation.h> <CGAL/PN_limit_surface_3/internal/tessellation/run_tessellation.h>)
set(_pn_read_fitting <CGAL/PN_fitting_3/internal/Mesh_limit_functionals.h> <CGAL/PN_fitting_3/internal/find_control_net.h>)
foreach(_pn_name double recognition limits fitting)
  set(_pn_library PN_subdivision_3_${_pn_name})
  if(TARGET ${_pn_library} OR (_pn_name STREQUAL "fitting" AND NOT TARGET ${_pn_package}_Eigen))
    continue()
  endif()
  file(GLOB _pn_files CONFIGURE_DEPENDS ${_pn_sources}/${_pn_library}/*.cpp)
  add_library(${_pn_library} STATIC EXCLUDE_FROM_ALL ${_pn_files})
  add_library(CGAL::${_pn_library} ALIAS ${_pn_library})
  string(TOUPPER CGAL_${_pn_library} _pn_macro)
  if(_pn_name STREQUAL "fitting")
    target_compile_definitions(${_pn_library} INTERFACE ${_pn_macro})
  else() # its sources leave to each other what they have
    target_compile_definitions(${_pn_library} PUBLIC ${_pn_macro})
  endif()
  target_link_libraries(${_pn_library} PUBLIC ${_pn_package})
  set_target_properties(${_pn_library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if(_pn_read_${_pn_name})
    target_precompile_headers(${_pn_library} PRIVATE ${_pn_read_${_pn_name}})
  endif()
  if(_pn_name STREQUAL "double") # what the others read has not the code of wide averages
    set_source_files_properties(${_pn_sources}/${_pn_library}/control_levels.cpp
                                PROPERTIES SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
  elseif(_pn_name STREQUAL "limits")
    target_link_libraries(${_pn_library} PUBLIC PN_subdivision_3_double)
  elseif(_pn_name STREQUAL "fitting")
    target_link_libraries(${_pn_library} PUBLIC PN_subdivision_3_limits ${_pn_package}_Eigen)
  endif()
endforeach()
unset(_pn_name)
unset(_pn_library)
unset(_pn_files)
unset(_pn_macro)
unset(_pn_read_double)
unset(_pn_read_limits)
unset(_pn_read_fitting)
