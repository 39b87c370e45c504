// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cell_geometry.hpp"

#include <cmath>

#include "core/element.hpp"

namespace parison::flow {

using core::dim;

namespace {

using NodePositions = std::array<std::array<Lanes, dim>, 6>;

NodePositions node_positions(const core::Mesh& mesh, const CellGeometry& geometry, Index batch) {
  NodePositions x;
  const auto at = [&](Index lane) -> const std::array<Index, 6>& { return mesh.cells[geometry.cell(batch, lane)]; };
  const auto &first = at(0), &second = at(1), &third = at(2), &fourth = at(3);
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a)
      packed_lanes(x[i][a]) = Pack{mesh.nodes[first[i]][a], mesh.nodes[second[i]][a], mesh.nodes[third[i]][a], mesh.nodes[fourth[i]][a]};
  return x;
}

void map_point(const NodePositions& x, const core::TriangleRulePoint& rule, core::Geometry geometry,
               CellGeometry::AtPoint& at) {
  const auto shape = core::triangle_shape(rule.a, rule.b);
  const auto slope = core::triangle_shape_derivative(rule.a, rule.b);
  Lanes jacobian[dim][2];
  for (int a = 0; a < dim; ++a) {
    at.position[a] = shape[0] * x[0][a];
    jacobian[a][0] = slope[0][0] * x[0][a];
    jacobian[a][1] = slope[0][1] * x[0][a];
    for (int i = 1; i < 6; ++i) {
      at.position[a] += shape[i] * x[i][a];
      jacobian[a][0] += slope[i][0] * x[i][a];
      jacobian[a][1] += slope[i][1] * x[i][a];
    }
  }
  const Lanes determinant = jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0];
  const Lanes s = 1 / determinant;
  const Lanes da_dr = s * jacobian[1][1], da_dz = -s * jacobian[0][1];
  const Lanes db_dr = -s * jacobian[1][0], db_dz = s * jacobian[0][0];
  for (int i = 0; i < 6; ++i) {
    at.gradient[i][0] = slope[i][0] * da_dr + slope[i][1] * db_dr;
    at.gradient[i][1] = slope[i][0] * da_dz + slope[i][1] * db_dz;
  }
  for (Index lane = 0; lane < lanes; ++lane) {
    const Point position(at.position[0][lane], at.position[1][lane]);
    at.volume[lane] = rule.weight * determinant[lane] * core::depth(geometry, position);
    at.hoop[lane] = core::hoop(geometry, position);
  }
}

}  // namespace

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry) {
  const auto& rule = core::triangle_rule(4);
  CellGeometry result;
  result.cells = mesh.cell_count();
  result.point.resize(std::size_t(result.batches()) * cell_points);
  for (Index batch = 0; batch < result.batches(); ++batch) {
    const NodePositions x = node_positions(mesh, result, batch);
    for (int q = 0; q < cell_points; ++q)
      map_point(x, rule[q], geometry, result.point[std::size_t(batch) * cell_points + q]);
  }
  return result;
}

const std::array<std::array<double, 6>, cell_points>& shapes_at_points() {
  static const auto table = [] {
    std::array<std::array<double, 6>, cell_points> shapes;
    const auto& rule = core::triangle_rule(4);
    for (int q = 0; q < cell_points; ++q) shapes[q] = core::triangle_shape(rule[q].a, rule[q].b);
    return shapes;
  }();
  return table;
}

BatchVelocity batch_velocity(const core::Mesh& mesh, const CellGeometry& geometry, Index batch,
                             const Eigen::VectorXd& velocity) {
  BatchVelocity result;
  const auto at = [&](Index lane) -> const std::array<Index, 6>& { return mesh.cells[geometry.cell(batch, lane)]; };
  const auto &first = at(0), &second = at(1), &third = at(2), &fourth = at(3);
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a)
      packed_lanes(result[i][a]) = Pack{velocity[dim * first[i] + a], velocity[dim * second[i] + a],
                                        velocity[dim * third[i] + a], velocity[dim * fourth[i] + a]};
  return result;
}

Lanes squared_rate(const CellGeometry::AtPoint& at, int q, const BatchVelocity& velocity) {
  const auto& shape = shapes_at_points()[q];
  Lanes rr = Lanes::Zero(), zz = rr, shear = rr, radial = rr;
  for (int i = 0; i < 6; ++i) {
    rr += velocity[i][0] * at.gradient[i][0];
    zz += velocity[i][1] * at.gradient[i][1];
    shear += velocity[i][0] * at.gradient[i][1] + velocity[i][1] * at.gradient[i][0];
    radial += shape[i] * velocity[i][0];
  }
  const Lanes ring = at.hoop * radial;
  return rr * rr + zz * zz + 0.5 * shear * shear + ring * ring;
}

}  // namespace parison::flow
