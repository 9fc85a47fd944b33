# Target preprint, where TeX is found: doc/PN_subdivision_3/approximation_order.tex, into build/.../doc/preprint.
find_program(PN_PDFLATEX pdflatex)
find_program(PN_BIBTEX bibtex)
mark_as_advanced(PN_PDFLATEX PN_BIBTEX)
if(PN_PDFLATEX AND PN_BIBTEX)
  set(pn_preprint ${PROJECT_BINARY_DIR}/doc/preprint)
  set(pn_latex ${PN_PDFLATEX} -interaction=batchmode -halt-on-error approximation_order)
  file(MAKE_DIRECTORY ${pn_preprint})
  add_custom_target(
    preprint
    COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/doc/PN_subdivision_3/approximation_order.tex
            ${PROJECT_SOURCE_DIR}/doc/PN_subdivision_3/PN_subdivision_3.bib .
    COMMAND ${pn_latex}
    COMMAND ${PN_BIBTEX} -terse approximation_order
    COMMAND ${pn_latex}
    COMMAND ${pn_latex}
    WORKING_DIRECTORY ${pn_preprint}
    VERBATIM)
endif()

# Target doc: the manual with plain Doxygen, into build/.../doc/html. What CGAL's documentation build does
# around Doxygen (bibliography, numbers of figures, formulas) is done by scripts/manual_pages.py.
find_package(Doxygen QUIET)
find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(NOT DOXYGEN_FOUND OR NOT Python3_FOUND)
  if(PN_SUBDIVISION_3_TESTS)
    pn_left_out(manual "Doxygen or Python 3.11 not found, the tests of the manual are left out (Debian package doxygen)")
  endif()
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
# the same, where a warning is an error
set(pn_checked ${PROJECT_BINARY_DIR}/doc_checked)
file(WRITE ${PROJECT_BINARY_DIR}/manual_checked.dxy
     "@INCLUDE = \"${PROJECT_BINARY_DIR}/manual.dxy\"\n"
     "OUTPUT_DIRECTORY = \"${pn_checked}\"\n"
     "WARN_AS_ERROR = FAIL_ON_WARNINGS\n")
file(MAKE_DIRECTORY ${pn_checked})
set(pn_manual_pages Python3::Interpreter -B ${PROJECT_SOURCE_DIR}/scripts/manual_pages.py)
# other versions of Doxygen warn of other things
if(PN_SUBDIVISION_3_TESTS AND DOXYGEN_VERSION VERSION_GREATER_EQUAL 1.9.2
   AND DOXYGEN_VERSION VERSION_LESS 1.10)
  add_test(NAME manual_begins_anew COMMAND ${CMAKE_COMMAND} -E rm -rf ${pn_checked}/html)
  add_test(NAME manual_bibliography COMMAND ${pn_manual_pages} prepare ${PROJECT_BINARY_DIR}/doc/made)
  add_test(NAME manual_without_warnings
           COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/manual_checked.dxy)
  add_test(NAME manual_references COMMAND ${pn_manual_pages} finish ${pn_checked}/html)
  set_tests_properties(manual_begins_anew manual_bibliography PROPERTIES FIXTURES_SETUP pn_bibliography)
  set_tests_properties(manual_without_warnings PROPERTIES FIXTURES_REQUIRED pn_bibliography
                       FIXTURES_SETUP pn_manual)
  set_tests_properties(manual_references PROPERTIES FIXTURES_REQUIRED pn_manual)
endif()
add_custom_target(
  doc
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${PROJECT_BINARY_DIR}/doc/html
  COMMAND ${pn_manual_pages} prepare ${PROJECT_BINARY_DIR}/doc/made
  COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/manual.dxy
  COMMAND ${pn_manual_pages} finish ${PROJECT_BINARY_DIR}/doc/html
  VERBATIM)
