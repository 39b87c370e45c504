// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mesh_hdf5.hpp"

#include <fmt/format.h>

namespace parison::core {

void write_points(Hdf5Group& group, const std::string& name, const std::vector<Point>& points) {
  std::vector<double> values;
  for (const Point& x : points) values.insert(values.end(), x.data(), x.data() + dim);
  group.write(name, values, dim);
}

std::vector<Point> read_points(const Hdf5Group& group, const std::string& name) {
  const std::vector<double> values = group.read_doubles(name);
  std::vector<Point> points(values.size() / dim);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = Eigen::Map<const Point>(values.data() + dim * i);
  return points;
}

void write_mesh(Hdf5Group group, const Mesh& mesh) {
  write_points(group, "nodes", mesh.nodes);
  group.write("vertex_count", std::int64_t{mesh.vertex_count()});
  std::vector<int> cells, boundary;
  for (const auto& cell : mesh.cells()) cells.insert(cells.end(), cell.begin(), cell.end());
  for (const BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index value : {edge.nodes[0], edge.nodes[1], edge.nodes[2], edge.cell, edge.boundary_id})
      boundary.push_back(value);
  group.write("cells", cells, 6);
  group.write("boundary", boundary, 5);
  std::vector<int> kinds;
  for (std::size_t i = 0; i < mesh.boundaries().size(); ++i) {
    group.write(fmt::format("boundary_{}", i), mesh.boundaries()[i].name);
    kinds.push_back(static_cast<int>(mesh.boundaries()[i].kind));
  }
  group.write("boundary_kinds", kinds);
}

Mesh read_mesh(const Hdf5Group& group) {
  Mesh mesh;
  Topology& topology = mesh.edit();
  mesh.nodes = read_points(group, "nodes");
  topology.vertex_count = static_cast<Index>(group.read_integer("vertex_count"));
  const std::vector<int> cells = group.read_integers("cells"), boundary = group.read_integers("boundary");
  topology.cells.resize(cells.size() / 6);
  for (std::size_t i = 0; i < cells.size(); ++i) topology.cells[i / 6][i % 6] = cells[i];
  for (std::size_t i = 0; i + 5 <= boundary.size(); i += 5)
    topology.boundary_edges.push_back(
        {{boundary[i], boundary[i + 1], boundary[i + 2]}, boundary[i + 3], boundary[i + 4]});
  const std::vector<int> kinds = group.read_integers("boundary_kinds");
  for (std::size_t i = 0; i < kinds.size(); ++i)
    topology.boundaries.emplace_back(group.read_string(fmt::format("boundary_{}", i)),
                                     static_cast<BoundaryKind>(kinds[i]));
  return mesh;
}

}  // namespace parison::core
