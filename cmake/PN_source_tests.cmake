# Tests of the sources themselves: data, figures, the list of CGAL packages that are used, notices.
set(pn_scripts ${PN_subdivision_3_SOURCE_DIR}/scripts)

find_package(Python3 3.11 QUIET COMPONENTS Interpreter)
if(Python3_FOUND)
  add_test(NAME data_is_in_order
           COMMAND Python3::Interpreter -B ${pn_scripts}/check_control_meshes.py)
  set(pn_compiler ${CMAKE_CXX_COMPILER})
  get_target_property(pn_cgal_folders CGAL::CGAL INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder ${pn_cgal_folders})
    if(IS_DIRECTORY "${folder}" AND NOT folder STREQUAL "/usr/include")
      string(APPEND pn_compiler " -I${folder}")
    endif()
  endforeach()
  if(TARGET CGAL::PN_subdivision_3_Eigen)
    get_target_property(pn_eigen_folder Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
    add_test(NAME sources_are_in_order
             COMMAND Python3::Interpreter -B ${pn_scripts}/check_sources.py
                     "--compiler=${pn_compiler} -I${pn_eigen_folder}")
  endif()

  add_test(NAME release_of_no_commit COMMAND ${pn_scripts}/make_release.sh no-such-tag)
  set_tests_properties(release_of_no_commit PROPERTIES
                       PASS_REGULAR_EXPRESSION "make_release.sh: no-such-tag: there is no such tag or commit")
  # no TeX is needed
  add_test(NAME preprint_has_tables_of_manual
           COMMAND Python3::Interpreter -B ${pn_scripts}/fill_tables.py --check)
  add_test(NAME package_does_not_grow
           COMMAND Python3::Interpreter -B ${pn_scripts}/check_budgets.py)
  add_test(NAME headers_lie_in_layers
           COMMAND Python3::Interpreter -B ${pn_scripts}/check_layers.py)
  add_test(NAME short_tests_catch_nearly_all
           COMMAND Python3::Interpreter -B ${pn_scripts}/mutate.py --tiers)
  if(PN_TEST_JOINED AND NOT PN_TEST_FULL)
    add_test(NAME table_has_all_tests
             COMMAND Python3::Interpreter -B ${pn_scripts}/test_table.py --check ${PN_subdivision_3_BINARY_DIR})
  endif()

  # skipped, with the reason, where VTK is not installed
  add_test(NAME render_draws
           COMMAND Python3::Interpreter -B
                   ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/pictures/test_render.py)
  set_tests_properties(render_draws PROPERTIES SKIP_REGULAR_EXPRESSION "^left out: ")

  if(TARGET subdivide_control_meshes)
    add_test(NAME control_meshes_of_any_origin
             COMMAND Python3::Interpreter -B
                     ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/pictures/test_control_meshes.py
                     $<TARGET_FILE:subdivide_control_meshes>)
  endif()

  # the drawings of the manual, against those that the examples have just written
  foreach(example_and_figure
          approximation_order average_arcs curve_bottle curve_circle curve_normal_edit far_from_origin kernel_precision
          extraordinary_curvature_table=extraordinary_curvature)
    string(REGEX MATCH "^[^=]+" example ${example_and_figure})
    string(REGEX MATCH "[^=]+$" figure ${example_and_figure})
    # elsewhere long double, which kernel_precision draws too, is another type
    if(TARGET ${example} AND (NOT example STREQUAL "kernel_precision"
                              OR CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64|i.86"))
      get_target_property(folder ${example} BINARY_DIR)
      add_test(
        NAME figure_${figure}
        COMMAND Python3::Interpreter -B ${pn_scripts}/compare_figures.py ${folder}/${figure}.svg
                ${PN_subdivision_3_SOURCE_DIR}/doc/PN_subdivision_3/fig/${figure}.svg)
      set_tests_properties(figure_${figure} PROPERTIES FIXTURES_REQUIRED drawn_${example})
    endif()
  endforeach()

  # the stencils of the manual, and the commands of README and manual, with the command that is built
  if(TARGET pn_subdivide)
    add_test(NAME diagrams_of_stencils
             COMMAND Python3::Interpreter -B ${pn_scripts}/make_diagrams.py --check
                     --command $<TARGET_FILE:${pn_tested_command}>)
    add_test(NAME documented_commands
             COMMAND Python3::Interpreter -B ${pn_scripts}/run_documented_commands.py
                     $<TARGET_FILE:${pn_tested_command}>)
    set_tests_properties(documented_commands PROPERTIES TIMEOUT 600)
  endif()

  # some numbers of the page that shows the paper's figures; scripts/pictures.py --check compares all
  if(TARGET pn_subdivide)
    add_test(NAME numbers_of_paper_figures
             COMMAND Python3::Interpreter -B ${pn_scripts}/make_paper_figures.py
                     --build ${PN_subdivision_3_BINARY_DIR} --check 3 4 11 17)
  endif()
else()
  pn_left_out(sources "Python 3.11 not found, the tests of data/, figures and documented commands are left out"
              " (Debian package python3)")
endif()

# The test of demo/PN_subdivision_3, where everything that the page needs is there: it builds the page, which
# takes some minutes unless nothing has changed.
find_program(PN_EMCMAKE emcmake)
find_program(PN_CHROMIUM chromium)
find_program(PN_NODE node)
find_program(PN_BASH bash)
if(PN_EMCMAKE AND PN_CHROMIUM AND PN_NODE AND PN_BASH AND TARGET pn_subdivide
   AND EXISTS ${PN_subdivision_3_SOURCE_DIR}/demo/PN_subdivision_3/node_modules/playwright-core)
  add_test(NAME page COMMAND ${PN_BASH} ${PN_subdivision_3_SOURCE_DIR}/scripts/test_page.sh --offline
                             --command $<TARGET_FILE:pn_subdivide>)
  set_tests_properties(page PROPERTIES TIMEOUT 3000 ENVIRONMENT "CHROMIUM=${PN_CHROMIUM}")
else()
  pn_left_out(page "the tools of the page not found (scripts/test_page.sh installs them and tests it)" OPTIONAL)
endif()
