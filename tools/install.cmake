# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install build` and the Debian package that `ninja -C build package` makes. The program looks for share/parison
# beside the folder it is in; in a build that leads back to the sources.
set(scripts render expect compare_heat plot_tradeoff show_in_paraview)

file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/parison ${CMAKE_BINARY_DIR}/bin)
foreach(folder cases tools)
  file(CREATE_LINK ${CMAKE_SOURCE_DIR}/${folder} ${CMAKE_BINARY_DIR}/share/parison/${folder} SYMBOLIC)
endforeach()

# The module of gmsh is beside nothing that the linker searches: program and Python package look for it by their run path.
install(TARGETS parison_gmsh DESTINATION lib/parison)
set_target_properties(parison PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/parison")
install(TARGETS parison DESTINATION bin)
install(DIRECTORY cases DESTINATION share/parison)
install(DIRECTORY tools/report/page DESTINATION share/parison/tools/report)
install(DIRECTORY tools/workbench/page DESTINATION share/parison/tools/workbench)
install(DIRECTORY tools/new_container/templates DESTINATION share/parison/tools/new_container)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/parison)
install(FILES LICENSE DESTINATION share/doc/parison RENAME copyright)
install(FILES tools/solid_view.py tools/written_files.py DESTINATION share/parison/tools)
foreach(script ${scripts})
  string(REPLACE "_" "-" command parison-${script})
  file(CREATE_LINK ../share/parison/tools/${script}.py ${CMAKE_BINARY_DIR}/bin/${command} SYMBOLIC)
  install(PROGRAMS tools/${script}.py DESTINATION share/parison/tools)
  install(PROGRAMS ${CMAKE_BINARY_DIR}/bin/${command} DESTINATION bin)
endforeach()

if(PARISON_PYTHON)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/python/parison)
  set(python_package __init__ case errors result)
  foreach(part ${python_package})
    file(CREATE_LINK ${CMAKE_SOURCE_DIR}/tools/python/parison/${part}.py ${CMAKE_BINARY_DIR}/python/parison/${part}.py SYMBOLIC)
  endforeach()
  install(DIRECTORY tools/python/parison DESTINATION lib/python3/dist-packages FILES_MATCHING PATTERN "*.py" PATTERN "*.pyi" PATTERN "py.typed")
  set_target_properties(python_module PROPERTIES INSTALL_RPATH "$ORIGIN/../../../parison")
  install(TARGETS python_module DESTINATION lib/python3/dist-packages/parison)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME parison)
set(CPACK_PACKAGE_CONTACT "The Parison developers <parison@example.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of the forming of glass containers")
set(CPACK_PACKAGE_DESCRIPTION "Parison computes how a gob of hot glass becomes a container: viscous
flow of the glass, heat in glass and tools, and the thermal contact between
them, on an axisymmetric or planar section. The bundled cases are found by
name: parison run jar.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-matplotlib, python3-numpy, python3-pil, python3-vtk9")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS paraview)
include(CPack)
