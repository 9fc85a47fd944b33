# Run by cpack on the files that it will pack: what Debian wants and an installation by CMake does not have.
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/man1/*.1)
foreach(page ${pages})
  execute_process(COMMAND gzip -9n ${page} COMMAND_ERROR_IS_FATAL ANY)
endforeach()

file(GLOB_RECURSE licenses ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/LICENSE.LGPL)
list(GET licenses 0 license)
get_filename_component(documents ${license} DIRECTORY)
file(REMOVE ${documents}/LICENSE.LGPL ${documents}/LICENSE.GPL) # common to all packages, in /usr/share/common-licenses
file(READ ${CPACK_PN_SOURCE}/package_info/PN_subdivision_3/debian_copyright copyright)
file(WRITE ${documents}/copyright "${copyright}")
file(RENAME ${documents}/CHANGES.md ${documents}/changelog)
execute_process(COMMAND gzip -9n ${documents}/changelog COMMAND_ERROR_IS_FATAL ANY)
