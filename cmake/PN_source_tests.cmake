# Tests of the sources themselves: data, the list of CGAL packages that are used, headers of files.
set(pn_scripts ${PN_subdivision_3_SOURCE_DIR}/scripts)

find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME data_is_what_its_script_makes
           COMMAND Python3::Interpreter -B ${pn_scripts}/make_control_meshes.py --check)
  add_test(NAME sources_are_in_order
           COMMAND Python3::Interpreter -B ${pn_scripts}/check_sources.py)
else()
  message(STATUS "PN_subdivision_3: Python 3.11 not found, the tests of data/ and of the sources'"
                 " headers are left out (Debian package python3)")
endif()
