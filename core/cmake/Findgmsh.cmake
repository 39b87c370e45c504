# SPDX-License-Identifier: GPL-3.0-or-later
# gmsh::gmsh, the C++ API.
find_path(gmsh_INCLUDE_DIR gmsh.h)
find_library(gmsh_LIBRARY gmsh)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(gmsh DEFAULT_MSG gmsh_INCLUDE_DIR gmsh_LIBRARY)
if(gmsh_FOUND AND NOT TARGET gmsh::gmsh)
  add_library(gmsh::gmsh INTERFACE IMPORTED)
  target_include_directories(gmsh::gmsh SYSTEM INTERFACE ${gmsh_INCLUDE_DIR})
  target_link_libraries(gmsh::gmsh INTERFACE ${gmsh_LIBRARY})
endif()
