# CGAL::PN_subdivision_3_double: a program that is linked to it does not compile the usual calls of subdivide() itself
# (internal/meshes/compiled_call.h). The library is made where it is used, by the compiler and with the options of
# that project, when something is first linked to it.
# Reads _pn_package, the target of the package, and _pn_sources, their folder. No function: an installed package leaves none behind.
add_library(
  PN_subdivision_3_double STATIC EXCLUDE_FROM_ALL
  ${_pn_sources}/CatmullClark_calls.cpp ${_pn_sources}/DooSabin_calls.cpp ${_pn_sources}/Loop_calls.cpp
  ${_pn_sources}/Sqrt3_calls.cpp)
add_library(CGAL::PN_subdivision_3_double ALIAS PN_subdivision_3_double)
target_link_libraries(PN_subdivision_3_double PUBLIC ${_pn_package})
target_compile_definitions(PN_subdivision_3_double INTERFACE CGAL_PN_SUBDIVISION_3_DOUBLE)
set_target_properties(PN_subdivision_3_double PROPERTIES POSITION_INDEPENDENT_CODE ON)
