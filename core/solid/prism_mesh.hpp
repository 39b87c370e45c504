#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/solid/quad_face.hpp"

namespace parison::core {

/// Prisms with 18 nodes: quadratic triangles, swept around the axis in quadratic steps. Node i + 6 k of a cell is node
/// i of its triangle on level k of three; the levels run against the angle, so that the Jacobian is positive. At the
/// axis nodes of the levels coincide: the cell has the same number more than once.
struct PrismMesh {
  static constexpr int nodes_per_cell = 18;
  std::vector<Vector3> nodes;  ///< m
  std::vector<std::array<Index, nodes_per_cell>> cells;
  std::vector<QuadFace> faces;           ///< of the swept boundary edges; the two cuts at the ends have none
  std::vector<MeshBoundary> boundaries;  ///< of the section: what `boundary_id` of the faces counts
  std::vector<Index> section_node;       ///< by node: that of the section from which it came
  std::vector<double> angle;             ///< by node, rad; of a node on the axis that of the first level

  Index node_count() const { return static_cast<Index>(nodes.size()); }
  Index cell_count() const { return static_cast<Index>(cells.size()); }
};

/// Where a point of the section (r, z), m, is in space at an angle, rad: (r cos, r sin, z) for a round body. Smooth;
/// right-handed in (r, angle, z). At r = 0 it does not depend on the angle.
using SectionMap = std::function<Vector3(double r, double z, double angle)>;
Vector3 round_section(double r, double z, double angle);

/// Sweeps a section through a range of angles in layers of equal angle. Edges on the axis (r = 0) make no faces.
PrismMesh sweep(const Mesh& section, double from_angle, double to_angle, Index layers,
                const SectionMap& map = round_section);

/// Nodal field of a swept mesh from one of its section.
Eigen::VectorXd from_section(const PrismMesh& mesh, const Eigen::VectorXd& section_values);

}  // namespace parison::core
