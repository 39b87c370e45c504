#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace parison::tools {

/// The most nodes of a body that a page can hold: they are numbered by words.
constexpr int most_nodes = 65536;

/// Throws core::RunError with the path and what is wrong with it.
[[noreturn]] void refuse_vtu(const std::string& path, const char* why);

/// Reads a .vtu file; throws core::RunError where it is missing or broken.
vtkSmartPointer<vtkUnstructuredGrid> read_grid(const std::string& path);

/// Nodes of each cell, one cell after another; throws core::RunError where a cell has another number of them.
std::vector<int> cells_of(vtkUnstructuredGrid& grid, int nodes_of_cell, const std::string& path);

/// Fields of one value a node, by name.
std::map<std::string, std::vector<float>> nodal_fields(vtkUnstructuredGrid& grid);

}  // namespace parison::tools
