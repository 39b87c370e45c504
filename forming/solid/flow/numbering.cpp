// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/numbering.hpp"

#include <Eigen/Geometry>
#include <array>

#include "core/linear/elimination_order.hpp"

namespace parison::flow {

namespace {

constexpr double same_direction = 1e-9;

/// Orthonormal directions of which the first `given` span the normals that a node meets.
struct Directions {
  Eigen::Matrix3d frame;
  int given = 0;

  void add(const Vector3& normal) {
    Vector3 rest = normal;
    for (int d = 0; d < given; ++d) rest -= rest.dot(frame.col(d)) * frame.col(d);
    if (given < 3 && rest.norm() > same_direction) frame.col(given++) = rest.normalized();
  }
  void complete() {
    const int chosen = given;
    for (int axis = 0; given < 3 && axis < 3; ++axis) add(Vector3::Unit(axis));
    given = chosen;
  }
};

/// Whether each given direction is an axis of space; then which.
bool along_axes(const Directions& directions, std::array<bool, 3>& given) {
  given = {};
  for (int d = 0; d < directions.given; ++d) {
    int axis = 0;
    if (directions.frame.col(d).cwiseAbs().maxCoeff(&axis) < 1 - same_direction * same_direction) return false;
    given[axis] = true;
  }
  return true;
}

std::vector<std::array<Index, 2>> edges_of(const HexMesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& cell : mesh.cells)
    for (int a = 0; a < HexMesh::nodes_per_cell; ++a)
      for (int b = 0; b < a; ++b) edges.push_back({cell[a], cell[b]});
  return edges;
}

}  // namespace

Numbering::Numbering(const HexMesh& mesh, const std::vector<SymmetryPlane>& planes, const std::vector<Index>& fixed)
    : frames_{Eigen::Matrix3d::Identity()}, frame_of_(mesh.nodes.size(), 0) {
  std::vector<Directions> directions(mesh.nodes.size());
  for (const SymmetryPlane& plane : planes)
    for (const Index node : plane.nodes) directions[node].add(plane.normal);
  for (const Index node : fixed) directions[node] = {Eigen::Matrix3d::Identity(), 3};
  std::vector<std::array<bool, 3>> given(mesh.nodes.size(), std::array<bool, 3>{});
  for (Index node = 0; node < mesh.node_count(); ++node) {
    if (along_axes(directions[node], given[node])) continue;
    directions[node].complete();
    frame_of_[node] = static_cast<Index>(frames_.size());
    frames_.push_back(directions[node].frame);
    for (int d = 0; d < 3; ++d) given[node][d] = d < directions[node].given;
  }
  number(mesh, given);
}

void Numbering::number(const HexMesh& mesh, const std::vector<std::array<bool, 3>>& given) {
  unknown_.assign(3 * mesh.nodes.size(), -1);
  for (const Index node : core::nested_dissection_order(mesh.node_count(), edges_of(mesh)))
    for (int d = 0; d < 3; ++d)
      if (!given[node][d]) unknown_[3 * node + d] = size_++;
}

Eigen::VectorXd Numbering::to_unknowns(const Eigen::VectorXd& space) const {
  Eigen::VectorXd result(size_);
  for (Index node = 0; 3 * node < space.size(); ++node) {
    const Vector3 own = frame(node).transpose() * space.segment<3>(3 * node);
    for (int d = 0; d < 3; ++d)
      if (const Index k = unknown(node, d); k >= 0) result[k] = own[d];
  }
  return result;
}

Eigen::VectorXd Numbering::to_space(const Eigen::VectorXd& unknowns) const {
  Eigen::VectorXd result(static_cast<Index>(unknown_.size()));
  for (Index node = 0; 3 * node < result.size(); ++node) {
    Vector3 own = Vector3::Zero();
    for (int d = 0; d < 3; ++d)
      if (const Index k = unknown(node, d); k >= 0) own[d] = unknowns[k];
    result.segment<3>(3 * node) = frame(node) * own;
  }
  return result;
}

}  // namespace parison::flow
