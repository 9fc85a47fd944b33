# Target doc: the manual with plain Doxygen, into build/.../doc/html. What CGAL's documentation build does
# around Doxygen (bibliography, numbers of figures, formulas) is done by scripts/manual_pages.py.
find_package(Doxygen QUIET)
find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  return()
endif()
set(CGAL_DOC_PACKAGE_DEFAULTS ${PROJECT_BINARY_DIR}/standalone.dxy)
set(CGAL_DOC_VERSION ${CGAL_VERSION})
configure_file(doc/PN_subdivision_3/standalone.dxy.in ${CGAL_DOC_PACKAGE_DEFAULTS} @ONLY)
configure_file(doc/PN_subdivision_3/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile)
# outside of CGAL the manual does not pose as a page of CGAL's own
file(WRITE ${PROJECT_BINARY_DIR}/manual.dxy
     "@INCLUDE = \"${PROJECT_BINARY_DIR}/Doxyfile\"\n"
     "PROJECT_NAME = PN_subdivision_3\n"
     "PROJECT_NUMBER = ${PROJECT_VERSION}\n"
     "PROJECT_BRIEF = \"${PROJECT_DESCRIPTION}\"\n")
add_custom_target(
  doc
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/doc/html
  COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/scripts/manual_pages.py prepare
          ${PROJECT_BINARY_DIR}/doc/made
  COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/manual.dxy
  COMMAND Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/scripts/manual_pages.py finish
          ${PROJECT_BINARY_DIR}/doc/html
  VERBATIM)
