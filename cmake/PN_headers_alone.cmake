# Target pn_headers_alone: every header compiles alone; and all compile in the company of what
# <windows.h> defines.
# Only checked, not translated: no code is generated.
set(include_dir ${PN_subdivision_3_SOURCE_DIR}/include)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include_dir}/*.h)
pn_leave_out_without_eigen(headers "headers")
set(generated ${PN_subdivision_3_BINARY_DIR}/generated/headers_alone)
set(sources)
set(external)
set(all_headers "")
foreach(header ${headers})
  file(RELATIVE_PATH relative ${include_dir} ${header})
  string(MAKE_C_IDENTIFIER ${relative} name)
  file(GENERATE OUTPUT ${generated}/${name}.cpp
       CONTENT "#include <${relative}>\n#include <${relative}>\n")
  list(APPEND sources ${generated}/${name}.cpp)
  string(APPEND all_headers "#include <${relative}>\n")
  pn_external_includes(further ${header})
  list(APPEND external ${further})
endforeach()

# the headers of others are not ours to mend: they come before the macros
list(REMOVE_DUPLICATES external)
list(TRANSFORM external REPLACE "(.+)" "#include <\\1>\n")
string(CONCAT others ${external})
file(GENERATE OUTPUT ${generated}/beside_windows_h.cpp
     CONTENT "${others}
#define near
#define far
#define small char
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
${all_headers}")
list(APPEND sources ${generated}/beside_windows_h.cpp)

add_library(pn_headers_alone OBJECT ${sources})
pn_own_target(pn_headers_alone)
# an empty object file is left for the build tool to see
target_compile_options(pn_headers_alone PRIVATE -fsyntax-only)
set_target_properties(pn_headers_alone PROPERTIES
                      CXX_COMPILER_LAUNCHER "${PN_subdivision_3_SOURCE_DIR}/cmake/PN_check_only.sh")
