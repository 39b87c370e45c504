// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/prism_mesh.hpp"

#include <cmath>

namespace parison::core {

namespace {

/// Numbers of the section's nodes on each level; all levels share those on the axis.
class SweptNodes {
 public:
  SweptNodes(const Mesh& section, Index levels) : at_axis_(section.nodes.size()), number_(section.nodes.size()) {
    const double on_axis = 1e-9 * size(section);
    for (std::size_t n = 0; n < section.nodes.size(); ++n) {
      at_axis_[n] = std::abs(section.nodes[n][0]) <= on_axis;
      number_[n] = count_;
      count_ += at_axis_[n] ? 1 : levels;
    }
  }
  bool at_axis(Index node) const { return at_axis_[node]; }
  Index operator()(Index node, Index level) const { return number_[node] + (at_axis_[node] ? 0 : level); }
  Index count() const { return count_; }

 private:
  std::vector<bool> at_axis_;
  std::vector<Index> number_;
  Index count_ = 0;
};

void add_cells(const Mesh& section, const SweptNodes& number, Index layers, PrismMesh& mesh) {
  for (Index layer = 0; layer < layers; ++layer) {
    for (const auto& triangle : section.cells()) {
      auto& cell = mesh.cells.emplace_back();
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 6; ++i) cell[i + 6 * k] = number(triangle[i], 2 * layer + k);
    }
    for (const BoundaryEdge& edge : section.boundary_edges()) {
      const auto& [first, last, mid] = edge.nodes;
      if (number.at_axis(first) && number.at_axis(last) && number.at_axis(mid)) continue;
      QuadFace& face = mesh.faces.emplace_back();
      face.boundary_id = edge.boundary_id;
      for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) face.nodes[i + 3 * k] = number(i == 0 ? first : i == 1 ? mid : last, 2 * layer + k);
    }
  }
}

}  // namespace

Vector3 round_section(double r, double z, double angle) {
  return {r * std::cos(angle), r * std::sin(angle), z};
}

PrismMesh sweep(const Mesh& section, double from_angle, double to_angle, Index layers, const SectionMap& map) {
  const Index levels = 2 * layers + 1;
  const SweptNodes number(section, levels);
  PrismMesh mesh;
  mesh.boundaries = section.boundaries();
  mesh.nodes.resize(number.count());
  mesh.section_node.resize(number.count());
  mesh.angle.resize(number.count());
  for (Index level = levels - 1; level >= 0; --level) {
    const double angle = to_angle + (from_angle - to_angle) * level / (levels - 1);
    for (Index n = 0; n < section.node_count(); ++n) {
      const Index node = number(n, level);
      const double r = number.at_axis(n) ? 0 : section.nodes[n][0];
      mesh.nodes[node] = map(r, section.nodes[n][1], angle);
      mesh.section_node[node] = n;
      mesh.angle[node] = angle;
    }
  }
  add_cells(section, number, layers, mesh);
  return mesh;
}

Eigen::VectorXd from_section(const PrismMesh& mesh, const Eigen::VectorXd& section_values) {
  Eigen::VectorXd values(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) values[n] = section_values[mesh.section_node[n]];
  return values;
}

}  // namespace parison::core
