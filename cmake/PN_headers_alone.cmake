# Target pn_headers_alone: all headers, and those of test_support/, compile in the company of what <windows.h>, Qt and <X11/Xlib.h>
# define, with -Wconversion; with PN_TEST_FULL together without it and every one alone, too, those with a documented name where they
# are used (test/PN_subdivision_3/headers/in_use.h). The internal ones take the headers of others precompiled, which saves minutes: that
# they include those themselves is seen where precompiled headers are off (build preset clang-headers).
# Only checked, not translated: no code is generated.
set(include_dir ${PN_subdivision_3_SOURCE_DIR}/include)
set(support_dir ${PN_subdivision_3_SOURCE_DIR}/test_support)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include_dir}/*.h ${support_dir}/*.h)
pn_leave_out_without_eigen(headers "headers")
set(generated ${PN_subdivision_3_BINARY_DIR}/generated/headers_alone)
set(sections ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3/headers/in_use.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sections})
file(STRINGS ${sections} in_use_of REGEX "defined")
list(TRANSFORM in_use_of REPLACE ".*defined\\((.*)\\)" "\\1")
set(public)
set(internal)
set(external)
set(all_headers "")
foreach(header ${headers})
  string(REPLACE "${include_dir}/" "" relative ${header})
  string(REPLACE "${support_dir}/" "" relative ${relative})
  string(MAKE_C_IDENTIFIER ${relative} name)
  set(in_use "")
  list(FIND in_use_of "IN_USE_${name}" place)
  if(NOT place EQUAL -1)
    set(in_use "#define IN_USE_${name}\n#include \"headers/in_use.h\"\n")
    list(REMOVE_AT in_use_of ${place})
  endif()
  file(GENERATE OUTPUT ${generated}/${name}.cpp
       CONTENT "#include <${relative}>\n#include <${relative}>\n${in_use}")
  if(relative MATCHES "/internal/")
    list(APPEND internal ${generated}/${name}.cpp)
  else()
    list(APPEND public ${generated}/${name}.cpp)
  endif()
  string(APPEND all_headers "#include <${relative}>\n")
  pn_external_includes(further ${header})
  list(APPEND external ${further})
endforeach()

if(in_use_of AND TARGET CGAL::PN_subdivision_3_Eigen)
  message(FATAL_ERROR "test/PN_subdivision_3/headers/in_use.h: there is no header of ${in_use_of}")
endif()

list(REMOVE_DUPLICATES external)
list(FILTER external EXCLUDE REGEX "^(test_support|schemes)/|parameters_interface.h$") # ours; calls of macros that whoever includes it defines
list(TRANSFORM external REPLACE "(.+)" "<\\1>")

# the headers of others are not ours to mend: they come before the macros
list(TRANSFORM external REPLACE "(.+)" "#include \\1\n" OUTPUT_VARIABLE others)
string(CONCAT others ${others})
file(GENERATE OUTPUT ${generated}/beside_macros.cpp
     CONTENT "${others}
#define near
#define far
#define small char
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define interface struct
#define emit
#define slots
#define signals public
#define foreach(variable, container) for (variable : container)
#define Bool int
#define Status int
#define None 0L
#define True 1
#define False 0
#define Success 0
${all_headers}")
file(GENERATE OUTPUT ${generated}/all_headers.cpp CONTENT "${all_headers}")
if(TARGET pn_warnings) # clang's -Wconversion is about signs, too
  set_source_files_properties(${generated}/beside_macros.cpp PROPERTIES
                              COMPILE_OPTIONS "-Wconversion;-Wno-sign-conversion")
endif()
set(together ${generated}/all_headers.cpp ${generated}/beside_macros.cpp)

set(targets pn_headers_alone)
if(PN_TEST_FULL)
  pn_precompile(pn_headers_of_others ${external})
  pn_own_target(pn_headers_of_others)
  add_library(pn_headers_alone OBJECT ${together} ${public})
  add_library(pn_internal_headers_alone OBJECT ${internal})
  target_precompile_headers(pn_internal_headers_alone REUSE_FROM pn_headers_of_others)
  add_dependencies(pn_headers_alone pn_internal_headers_alone)
  list(APPEND targets pn_internal_headers_alone)
else()
  add_library(pn_headers_alone OBJECT EXCLUDE_FROM_ALL ${generated}/beside_macros.cpp)
  add_dependencies(pn_long_tests pn_headers_alone)
endif()
foreach(target ${targets})
  pn_own_target(${target})
  target_include_directories(${target} PRIVATE ${PN_subdivision_3_SOURCE_DIR}/test/PN_subdivision_3)
  set_target_properties(${target} PROPERTIES
                        CXX_COMPILER_LAUNCHER "${PN_subdivision_3_SOURCE_DIR}/cmake/PN_check_only.sh")
endforeach()
