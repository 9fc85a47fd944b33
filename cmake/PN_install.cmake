# Installs the headers, the files that find_package(PN_subdivision_3 CONFIG) and pkg-config read, the examples with
# their meshes, and the command. Components: PN_subdivision_3 (all that a program needs, with licenses),
# PN_subdivision_3_examples, pn_subdivide.
include(CMakePackageConfigHelpers)

set(pn_config_dir ${CMAKE_INSTALL_DATADIR}/cmake/PN_subdivision_3)
set(pn_component COMPONENT PN_subdivision_3)

configure_file(${CMAKE_CURRENT_LIST_DIR}/PN_subdivision_3Config.cmake.in
               ${PROJECT_BINARY_DIR}/PN_subdivision_3Config.cmake @ONLY)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/PN_subdivision_3ConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)
install(TARGETS PN_subdivision_3 EXPORT PN_subdivision_3Targets)
install(EXPORT PN_subdivision_3Targets NAMESPACE CGAL:: DESTINATION ${pn_config_dir} ${pn_component})
install(FILES ${PROJECT_BINARY_DIR}/PN_subdivision_3Config.cmake
              ${PROJECT_BINARY_DIR}/PN_subdivision_3ConfigVersion.cmake
        DESTINATION ${pn_config_dir} ${pn_component})

# a library that is compiled where it is used
install(FILES ${CMAKE_CURRENT_LIST_DIR}/PN_subdivision_3_double.cmake DESTINATION ${pn_config_dir} ${pn_component})
install(DIRECTORY src/PN_subdivision_3_double DESTINATION ${CMAKE_INSTALL_DATADIR}/PN_subdivision_3/src ${pn_component})

# found from its own place, so that the installed package can be moved
file(RELATIVE_PATH pn_includedir_from_pc ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
     ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(${CMAKE_CURRENT_LIST_DIR}/PN_subdivision_3.pc.in ${PROJECT_BINARY_DIR}/PN_subdivision_3.pc
               @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/PN_subdivision_3.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig
        ${pn_component})

install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${pn_component})
install(FILES LICENSE.LGPL LICENSE.GPL README.md CHANGES.md DESTINATION ${CMAKE_INSTALL_DOCDIR}
        ${pn_component})

# side by side: there CGAL::data_file_path() finds the meshes. Examples that include test_support/, which is not installed,
# are not either.
file(GLOB_RECURSE pn_example_files CONFIGURE_DEPENDS examples/*.cpp examples/*.h)
set(pn_not_installed)
foreach(file ${pn_example_files})
  pn_external_includes(external ${file})
  if(external MATCHES "(^|;)test_support/")
    get_filename_component(name ${file} NAME)
    list(APPEND pn_not_installed PATTERN ${name} EXCLUDE)
  endif()
endforeach()
install(DIRECTORY data examples DESTINATION ${CMAKE_INSTALL_DATADIR}/PN_subdivision_3
        COMPONENT PN_subdivision_3_examples ${pn_not_installed})

if(TARGET pn_subdivide)
  # optional: whoever wants the headers alone need not build the command
  install(TARGETS pn_subdivide OPTIONAL
          RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT pn_subdivide)
  install(FILES src/pn_subdivide/pn_subdivide.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          COMPONENT pn_subdivide)
  install(
    CODE "if(NOT EXISTS \"$<TARGET_FILE:pn_subdivide>\")
            message(STATUS \"Left out: pn_subdivide, which has not been built (target pn_subdivide)\")
          endif()"
    COMPONENT pn_subdivide)
endif()
