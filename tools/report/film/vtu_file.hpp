#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace parison::tools {

/// Of a quadratic triangle.
inline constexpr int nodes_of_cell = 6;

/// A body at an output time, as a run has written it.
struct VtuFile {
  std::vector<std::array<float, 2>> points;         ///< mm
  std::vector<std::uint16_t> cells;                 ///< of quadratic triangles: corners, then mid-side nodes
  std::map<std::string, std::vector<float>> nodal;  ///< fields of one value a node, by name
  bool active = true;                               ///< of a tool: the stage names it
};

/// Reads a .vtu file of a result folder; throws core::RunError where it is missing, broken, or has more nodes than a
/// page can hold.
VtuFile read_vtu(const std::string& path);

/// A file of a .pvd and its time.
struct PvdEntry {
  double time;       ///< s
  std::string path;  ///< below the folder of the collection
};

/// The files of a time series that are there, without any that would lie outside the folder; empty without the .pvd.
std::vector<PvdEntry> read_pvd(const std::string& path);

}  // namespace parison::tools
