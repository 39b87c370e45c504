#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/solid/solid_files.hpp"
#include "forming/report/wall/solid_wall.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// A STEP file of a container in space.
struct SmoothSolid {
  double volume;      ///< m3
  double from_nodes;  ///< largest distance of its surface from nodes of the glass, m
  double from_faces;  ///< the same from faces of the glass between them, m
};
/// Writes the whole container as one solid, mm: smooth surfaces through the nodes of its sides and of its rim. Throws
/// core::RunError where the CAD kernel finds them open or crossing themselves.
SmoothSolid write_step(const std::string& path, const SolidState& solid);

/// Writes the surface of the whole container as triangles, mm, binary STL with outward normals. Returns the volume that
/// they enclose, m3.
double write_stl(const std::string& path, const SolidState& solid);

/// Writes the middle of the wall of the whole container as shell_text does: a shell for each cell along the wall, S6 at
/// the axis of narrow sectors.
ShellMesh write_shell(const std::string& path, const SolidState& solid, const ShellGlass& glass);

}  // namespace parison::forming
