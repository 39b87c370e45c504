#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace parison::tools {

/// Where a face of glass in space lies; the planes are those of symmetry, at angle 0 and at the end of the sector.
enum class SurfaceSide : std::uint8_t { inner, outer, rim, first_plane, last_plane };

/// The closed surface of a sector of glass in space at an output time.
struct SolidSurface {
  std::vector<std::array<float, 3>> points;  ///< mm, of the nodes of the surface
  std::vector<std::uint16_t> faces;          ///< nine nodes each: entry a + 3 b is at (a, b)/2 of the face
  std::vector<std::uint16_t> sides;          ///< a SurfaceSide for each face
  std::map<std::string, std::vector<float>> nodal;
  int copies = 1;  ///< sectors in the whole turn
};

/// Reads the surface of hexahedra with 27 nodes whose third coordinate goes through the wall; throws core::RunError
/// where the file is missing or broken, or the surface has more nodes than a page can hold.
SolidSurface read_solid_surface(const std::string& path);

}  // namespace parison::tools
