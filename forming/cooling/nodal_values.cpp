// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/cooling/nodal_values.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <utility>
#include <vector>

#include "core/mesh/cell_batch.hpp"

namespace parison::cooling {

using core::cell_points;
using core::Index;
using core::Point;

namespace {

using Terms = Eigen::Matrix<double, 6, 1>;

/// The straight functions of a cell by an orthonormal basis of their values at its points.
struct StraightPart {
  Eigen::Matrix<double, 3, cell_points> nearest;  ///< coefficients of the straight function nearest to a function
  Eigen::Matrix<double, 3, cell_points> along;    ///< products of the basis with values

  StraightPart() {
    const Eigen::Matrix<double, cell_points, 3> linear = core::cell_shapes<3>().value;
    Eigen::Matrix<double, 3, cell_points> weighted;
    for (int q = 0; q < cell_points; ++q)
      weighted.col(q) = core::triangle_rule(4)[q].weight * linear.row(q).transpose();
    const Eigen::HouseholderQR<Eigen::Matrix<double, cell_points, 3>> orthonormal(linear);
    const Eigen::Matrix<double, cell_points, cell_points> basis = orthonormal.householderQ();
    along = basis.leftCols<3>().transpose();
    nearest = along * linear * Eigen::Matrix3d(weighted * linear).inverse() * weighted;
  }
};

/// 1, x, y, x^2, x y, y^2 at a place, in units of a size about a centre.
Terms terms_at(const Point& place, const Point& centre, double size) {
  const Point x = (place - centre) / size;
  Terms terms;
  terms << 1, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1];
  return terms;
}

/// Components that a field of points has at most: those of a stress.
constexpr int most_components = 4;

/// A quadratic function of each component around a vertex.
struct Patch {
  Point centre;
  double size;
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, most_components> coefficients;

  Eigen::VectorXd at(const Point& place) const { return coefficients.transpose() * terms_at(place, centre, size); }
};

using Neighbours = std::vector<std::vector<Index>>;

Neighbours cells_of_vertices(const core::Mesh& mesh) {
  Neighbours cells(mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int v = 0; v < 3; ++v) cells[mesh.cells()[c][v]].push_back(c);
  return cells;
}

/// The cells around a vertex and those that share a vertex with them. `last_near` has for each cell the last vertex
/// that it was near.
std::vector<Index> cells_near(const core::Mesh& mesh, const Neighbours& around, Index vertex,
                              std::vector<Index>& last_near) {
  std::vector<Index> near;
  for (const Index cell : around[vertex])
    for (int v = 0; v < 3; ++v)
      for (const Index more : around[mesh.cells()[cell][v]])
        if (std::exchange(last_near[more], vertex) != vertex) near.push_back(more);
  return near;
}

std::vector<Point> place_of_points(const core::Mesh& mesh) {
  const auto& shape = core::cell_shapes<6>().value;
  std::vector<Point> places;
  for (const auto& cell : mesh.cells())
    for (int q = 0; q < cell_points; ++q) {
      Point place = Point::Zero();
      for (int i = 0; i < 6; ++i) place += shape(q, i) * mesh.nodes[cell[i]];
      places.push_back(place);
    }
  return places;
}

/// The function whose straight parts in some cells are nearest to the values at their points: stress has these alone. A
/// trace of the sum of squares gives one where the cells are so few that it is not determined.
/// `along`: products with the values of each cell, a row for each straight function, columns for the components.
Patch fit(const Point& centre, const std::vector<Index>& cells, const std::vector<Point>& places,
          const StraightPart& straight, const Eigen::Matrix<double, 3, Eigen::Dynamic>& along, Index components) {
  constexpr double trace = 1e-9;
  Patch patch{centre, 0, decltype(Patch::coefficients)::Zero(6, components)};
  for (const Index c : cells)
    for (int q = 0; q < cell_points; ++q)
      patch.size = std::max(patch.size, (places[c * cell_points + q] - centre).norm());
  Eigen::Matrix<double, 6, 6> squares = trace * Eigen::Matrix<double, 6, 6>::Identity();
  for (const Index c : cells) {
    Eigen::Matrix<double, cell_points, 6> terms;
    for (int q = 0; q < cell_points; ++q)
      terms.row(q) = terms_at(places[c * cell_points + q], centre, patch.size).transpose();
    const Eigen::Matrix<double, 3, 6> nearest = straight.nearest * terms;
    squares.noalias() += nearest.transpose() * nearest;
    patch.coefficients += nearest.transpose().lazyProduct(along.middleCols(c * components, components));
  }
  squares.ldlt().solveInPlace(patch.coefficients);
  return patch;
}

}  // namespace

Eigen::VectorXd to_nodes(const core::Mesh& mesh, const Eigen::VectorXd& at_points, Index components,
                         const std::vector<bool>& vertices) {
  static const StraightPart straight;
  Eigen::Matrix<double, 3, Eigen::Dynamic> along(3, components * mesh.cell_count());
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Eigen::Map<const Eigen::MatrixXd> values(at_points.data() + c * cell_points * components, components,
                                                   cell_points);
    along.middleCols(c * components, components) = straight.along * values.transpose();
  }
  const Neighbours around = cells_of_vertices(mesh);
  const std::vector<Point> places = place_of_points(mesh);
  std::vector<Patch> patches(mesh.vertex_count());
  std::vector<Index> last_near(mesh.cells().size(), -1);
  const auto is_wanted = [&](Index vertex) { return vertices.empty() || vertices[vertex]; };
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (is_wanted(v))
      patches[v] = fit(mesh.nodes[v], cells_near(mesh, around, v, last_near), places, straight, along, components);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(components, mesh.node_count());
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (is_wanted(v)) result.col(v) = patches[v].at(mesh.nodes[v]);
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) {
      const Index middle = cell[3 + i], first = cell[i], last = cell[(i + 1) % 3];
      const Point& place = mesh.nodes[middle];
      if (is_wanted(first) && is_wanted(last))
        result.col(middle) = 0.5 * (patches[first].at(place) + patches[last].at(place));
    }
  return Eigen::Map<const Eigen::VectorXd>(result.data(), result.size());
}

}  // namespace parison::cooling
