# Run by cpack on the files that it will pack: what Debian wants and an installation by CMake does not have.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*.1)
foreach(page ${pages})
  execute_process(COMMAND gzip -9n ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

file(GLOB_RECURSE licenses ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/LICENSE.LGPL)
list(GET licenses 0 license)
get_filename_component(documents ${license} DIRECTORY)
file(REMOVE ${documents}/LICENSE.LGPL ${documents}/LICENSE.GPL) # common to all packages, in /usr/share/common-licenses
file(READ ${CPACK_PN_SOURCE}/package_info/PN_subdivision_3/debian_copyright copyright)
file(WRITE ${documents}/copyright "${copyright}")
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC) # of SOURCE_DATE_EPOCH where it is set
file(WRITE ${documents}/changelog
     "pn-subdivision-3 (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n  * What is new is in CHANGES.md.\n\n"
     " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
execute_process(COMMAND gzip -9n ${documents}/changelog COMMAND_ERROR_IS_FATAL ANY)

# CGAL's intervals need this option of the compiler
get_filename_component(share ${documents}/../.. ABSOLUTE)
file(WRITE ${share}/lintian/overrides/pn-subdivision-3
     "pn-subdivision-3: pkg-config-bad-directive -frounding-math [usr/share/pkgconfig/PN_subdivision_3.pc]\n")
