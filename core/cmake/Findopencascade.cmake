# SPDX-License-Identifier: GPL-3.0-or-later
# opencascade::opencascade, the parts that read STEP files and cut or triangulate solids. Its own package file asks for
# the headers of all parts.
find_path(opencascade_INCLUDE_DIR STEPControl_Reader.hxx PATH_SUFFIXES opencascade)
set(opencascade_parts TKSTEP TKXSBase TKMesh TKBO TKTopAlgo TKGeomAlgo TKBRep TKGeomBase TKG3d TKMath TKernel)
set(opencascade_LIBRARIES)
foreach(part ${opencascade_parts})
  find_library(opencascade_${part} ${part})
  list(APPEND opencascade_LIBRARIES ${opencascade_${part}})
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(opencascade DEFAULT_MSG opencascade_INCLUDE_DIR opencascade_TKSTEP opencascade_TKBO
  opencascade_LIBRARIES)
if(opencascade_FOUND AND NOT TARGET opencascade::opencascade)
  add_library(opencascade::opencascade INTERFACE IMPORTED)
  target_include_directories(opencascade::opencascade SYSTEM INTERFACE ${opencascade_INCLUDE_DIR})
  target_link_libraries(opencascade::opencascade INTERFACE ${opencascade_LIBRARIES})
endif()
