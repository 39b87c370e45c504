#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/io/hdf5.hpp"
#include "core/mesh/mesh.hpp"

namespace parison::core {

void write_points(Hdf5Group& group, const std::string& name, const std::vector<Point>& points);
std::vector<Point> read_points(const Hdf5Group& group, const std::string& name);

/// Writes a mesh into a group of its own, bit for bit.
void write_mesh(Hdf5Group group, const Mesh& mesh);
Mesh read_mesh(const Hdf5Group& group);

}  // namespace parison::core
