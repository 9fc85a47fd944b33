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

# libraries that are compiled where they are used
install(FILES ${CMAKE_CURRENT_LIST_DIR}/PN_libraries.cmake DESTINATION ${pn_config_dir} ${pn_component})
install(DIRECTORY src/PN_subdivision_3_double src/PN_subdivision_3_fitting src/PN_subdivision_3_limits src/PN_subdivision_3_recognition
        DESTINATION ${CMAKE_INSTALL_DATADIR}/PN_subdivision_3/src ${pn_component})

# found from its own place, so that the installed package can be moved
file(RELATIVE_PATH pn_includedir_from_pc ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig
     ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(WRITE ${PROJECT_BINARY_DIR}/PN_subdivision_3.pc
     "# The headers of CGAL and Boost, which have no such file, are those on the compiler's path.
includedir=\${pcfiledir}/${pn_includedir_from_pc}

Name: PN_subdivision_3
Description: ${PROJECT_DESCRIPTION}
Version: ${PROJECT_VERSION}
Cflags: -I\${includedir} -frounding-math
Libs: -lmpfr -lgmp
")
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

if(NOT PN_TOP_LEVEL)
  return()
endif()

# --- cpack -G DEB: one Debian package of the command, its manual page, the headers and what find_package() reads.
# PN_PACKAGE_VERSION and PN_PACKAGE_CONTACT ("Name <address>") are set by scripts/make_release.sh.
set(PN_PACKAGE_VERSION "${PROJECT_VERSION}" CACHE STRING "Version of the Debian package")
set(PN_PACKAGE_CONTACT "PN_subdivision_3 developers <unknown@localhost>" CACHE STRING "Its maintainer")
mark_as_advanced(PN_PACKAGE_VERSION PN_PACKAGE_CONTACT)

set(CPACK_PACKAGE_NAME pn-subdivision-3)
set(CPACK_PACKAGE_VERSION "${PN_PACKAGE_VERSION}")
set(CPACK_PACKAGE_CONTACT "${PN_PACKAGE_CONTACT}")
set(CPACK_COMPONENTS_ALL PN_subdivision_3 pn_subdivide)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_NAME pn-subdivision-3)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS libcgal-dev) # what the headers include
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libtbb-dev")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
file(READ package_info/PN_subdivision_3/long_description.txt CPACK_PACKAGE_DESCRIPTION)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/PN_package_files.cmake)
set(CPACK_PN_SOURCE ${PROJECT_SOURCE_DIR})
include(CPack)
