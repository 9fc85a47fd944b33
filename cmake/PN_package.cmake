# cpack -G DEB: one Debian package of the command, its manual page, the headers and what find_package() reads.
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
