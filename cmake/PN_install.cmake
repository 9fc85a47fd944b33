# Installs the headers and the files that find_package(PN_subdivision_3 CONFIG) reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(PN_config_dir ${CMAKE_INSTALL_DATADIR}/cmake/PN_subdivision_3)

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/PN_subdivision_3Config.cmake.in
  ${PROJECT_BINARY_DIR}/PN_subdivision_3Config.cmake
  INSTALL_DESTINATION ${PN_config_dir}
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/PN_subdivision_3ConfigVersion.cmake
  COMPATIBILITY SameMinorVersion
  ARCH_INDEPENDENT)

install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT PN_subdivision_3)
install(
  FILES ${PROJECT_BINARY_DIR}/PN_subdivision_3Config.cmake
        ${PROJECT_BINARY_DIR}/PN_subdivision_3ConfigVersion.cmake
        ${CMAKE_CURRENT_LIST_DIR}/PN_subdivision_3_dependencies.cmake
  DESTINATION ${PN_config_dir} COMPONENT PN_subdivision_3)
