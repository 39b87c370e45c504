#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/solid/container_shape.hpp"
#include "forming/report/solid/shell_file.hpp"

namespace parison::forming {

/// Writes the container as one solid, mm: its outline as splines that pass through the points and break at corners,
/// turned about the z axis. Returns the volume of the solid, m3. Throws core::RunError where the CAD kernel cannot.
double write_step(const std::string& path, const ContainerShape& shape);

/// Writes its surface as triangles, mm, binary STL with outward normals; flat sides deviate from the circle by at most
/// `deviation`, m, and are 120 at least. Returns the volume that they enclose, m3.
double write_stl(const std::string& path, const ContainerShape& shape, double deviation = 1e-5);

/// A shell that was written.
struct ShellMesh {
  long elements, nodes;
  double volume;  ///< of the middle surface times the thickness, m3
};
/// Writes the middle of the wall as shell_text does, with S6 at the axis. At least `divisions` go around, with sides
/// twice as long as along the wall; more in a thin wall with residual stress. Throws core::CaseError where the glass is
/// no wall.
ShellMesh write_shell(const std::string& path, const ContainerShape& shape, ShellGlass glass, int divisions = 48);

}  // namespace parison::forming
