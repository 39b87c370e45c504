// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/solid/cell_places.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

#include "core/solid/hex_geometry.hpp"

namespace parison::remesh {

namespace {

using core::Vector3;

/// How far a place is out of the unit cube.
double beyond(const Vector3& at) {
  return std::max({0.0, -at.minCoeff(), at.maxCoeff() - 1});
}

/// Newton's method for the coordinates of a position in a cell, in short steps where the cell is bent; false where it
/// does not get there.
bool locate(const core::HexNodes& nodes, const Vector3& position, Vector3& at) {
  constexpr int iterations = 40;
  constexpr double farthest = 1, longest = 0.25, close = 1e-13;
  for (int i = 0; i < iterations; ++i) {
    const Eigen::Matrix3d slope = nodes * core::hex_shape_derivative(at).transpose();
    Vector3 change = slope.partialPivLu().solve(position - nodes * core::hex_shape(at));
    const double length = change.cwiseAbs().maxCoeff();
    if (length > longest) change *= longest / length;
    at += change;
    if (!(beyond(at) < farthest)) return false;
    if (length < close) return true;
  }
  return false;
}

class Finder {
 public:
  explicit Finder(const core::HexMesh& mesh) : mesh_(&mesh), cells_of_(mesh.nodes.size()) {
    for (Index cell = 0; cell < mesh.cell_count(); ++cell)
      for (const Index node : mesh.cells[cell]) cells_of_[node].push_back(cell);
  }

  CellPlace find(Index node, const Vector3& position) const {
    constexpr double bearable = 1e-9;
    std::vector<Index> near = cells_of_[node];
    CellPlace place = best_of(near, position);
    if (beyond(place.at) <= bearable) return place;
    constexpr int most_rings = 4;  // of cells about those of the node
    for (int ring = 0; ring < most_rings && beyond(place.at) > bearable; ++ring) {
      for (const Index cell : std::vector<Index>(near))
        for (const Index other : mesh_->cells[cell])
          near.insert(near.end(), cells_of_[other].begin(), cells_of_[other].end());
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      place = best_of(near, position);
    }
    return place;
  }

  /// The place of a node itself.
  CellPlace own(Index node) const {
    const Index cell = cells_of_[node].front();
    const auto& nodes = mesh_->cells[cell];
    const auto local = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
    return {cell, 0.5 * Vector3(double(local % 3), double((local / 3) % 3), double(local / 9))};
  }

 private:
  CellPlace best_of(const std::vector<Index>& cells, const Vector3& position) const {
    CellPlace best{cells.front(), Vector3::Constant(0.5)};
    double least = std::numeric_limits<double>::infinity();
    for (const Index cell : cells) {
      Vector3 at = Vector3::Constant(0.5);
      if (!locate(core::cell_nodes(*mesh_, cell), position, at) || !(beyond(at) < least)) continue;
      least = beyond(at);
      best = {cell, at};
    }
    return best;
  }

  const core::HexMesh* mesh_;
  std::vector<std::vector<Index>> cells_of_;
};

}  // namespace

std::vector<CellPlace> cell_places(const core::HexMesh& mesh, const std::vector<Vector3>& moved) {
  const Finder finder(mesh);
  std::vector<CellPlace> places;
  places.reserve(moved.size());
  for (Index node = 0; node < mesh.node_count(); ++node)
    places.push_back(moved[node] == mesh.nodes[node] ? finder.own(node) : finder.find(node, moved[node]));
  return places;
}

Eigen::VectorXd values_at(const core::HexMesh& mesh, const std::vector<CellPlace>& places, const Eigen::VectorXd& field,
                          Index components) {
  Eigen::VectorXd result(field.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    const core::HexShape shape = core::hex_shape(places[n].at);
    const auto& nodes = mesh.cells[places[n].cell];
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(components);
    for (int k = 0; k < core::HexMesh::nodes_per_cell; ++k)
      sum += shape[k] * field.segment(components * nodes[k], components);
    result.segment(components * static_cast<Index>(n), components) = sum;
  }
  return result;
}

}  // namespace parison::remesh
