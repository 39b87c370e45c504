#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/report/solid/solid_files.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Volume of the glass of the whole container, m3.
double whole_volume(const SolidState& solid);

/// Writes the surface of the whole container as triangles, mm, binary STL with outward normals. Returns the volume that
/// they enclose, m3.
double write_stl(const std::string& path, const SolidState& solid);

/// Writes the middle of the wall of the whole container as shell_text does: a shell for each cell along the wall, S6 at
/// the axis of narrow sectors.
ShellMesh write_shell(const std::string& path, const SolidState& solid, const ShellGlass& glass);

}  // namespace parison::forming
