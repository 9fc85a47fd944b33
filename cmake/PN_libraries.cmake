# Static libraries for programs that shall not compile everything themselves: CGAL::PN_subdivision_3_double has the usual calls of
# subdivide() (internal/meshes/compiled_call.h); for every mesh and kernel CGAL::PN_subdivision_3_limits has the limits of levels of
# double (PN_limit_surface_3/internal/limit/compiled_limits.h), CGAL::PN_subdivision_3_recognition recognition. They are made where they are used, by the compiler and with the options of that project, when something is
# first linked to them.
# Reads _pn_package, the target of the package, and _pn_sources, the folder of their sources. No function: an installed package
# leaves none behind.
if(NOT TARGET PN_subdivision_3_double)
  add_library(
    PN_subdivision_3_double STATIC EXCLUDE_FROM_ALL
    ${_pn_sources}/PN_subdivision_3_double/CatmullClark_calls.cpp ${_pn_sources}/PN_subdivision_3_double/DooSabin_calls.cpp
    ${_pn_sources}/PN_subdivision_3_double/Loop_calls.cpp ${_pn_sources}/PN_subdivision_3_double/Sqrt3_calls.cpp)
  target_compile_definitions(PN_subdivision_3_double INTERFACE CGAL_PN_SUBDIVISION_3_DOUBLE)
  add_library(PN_subdivision_3_recognition STATIC EXCLUDE_FROM_ALL ${_pn_sources}/PN_subdivision_3_recognition/recognition.cpp)
  target_compile_definitions(PN_subdivision_3_recognition PUBLIC CGAL_PN_SUBDIVISION_3_RECOGNITION)
  add_library(
    PN_subdivision_3_limits STATIC EXCLUDE_FROM_ALL
    ${_pn_sources}/PN_subdivision_3_limits/CatmullClark_limits.cpp ${_pn_sources}/PN_subdivision_3_limits/Loop_limits.cpp
    ${_pn_sources}/PN_subdivision_3_limits/quad_limits.cpp ${_pn_sources}/PN_subdivision_3_limits/triangle_limits.cpp)
  target_compile_definitions(PN_subdivision_3_limits INTERFACE CGAL_PN_SUBDIVISION_3_LIMITS)
  foreach(_pn_library PN_subdivision_3_double PN_subdivision_3_limits PN_subdivision_3_recognition)
    add_library(CGAL::${_pn_library} ALIAS ${_pn_library})
    target_link_libraries(${_pn_library} PUBLIC ${_pn_package})
    set_target_properties(${_pn_library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endforeach()
  unset(_pn_library)
endif()
