// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_geometry.hpp"

#include <algorithm>

#include "core/mesh/element.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// The nodes of the cells of a batch.
struct BatchNodes {
  const std::array<Index, 6>* of[batch_size];

  BatchNodes(const core::Mesh& mesh, Index batch) {
    for (Index lane = 0; lane < batch_size; ++lane)
      of[lane] = &mesh.cells()[std::min(batch * batch_size + lane, mesh.cell_count() - 1)];
  }
};

struct NodeVectors {
  VectorizedArray at[6][dim];
};

/// Vectors at the nodes, from coordinates in a row; put together where they are used: vectors stored in parts are slow
/// to load.
[[gnu::always_inline]] inline void gather(const BatchNodes& nodes, const double* values, NodeVectors& x) {
  for (int i = 0; i < 6; ++i) {
    const double* from[batch_size];
    for (Index lane = 0; lane < batch_size; ++lane) from[lane] = values + dim * (*nodes.of[lane])[i];
    for (int a = 0; a < dim; ++a) x.at[i][a] = VectorizedArray{from[0][a], from[1][a], from[2][a], from[3][a]};
  }
}

const double* coordinates(const core::Mesh& mesh) {
  return mesh.nodes.front().data();
}

/// Shape functions and their derivatives at the quadrature points.
struct Shapes {
  std::array<double, 6> value[cell_points];
  std::array<std::array<double, 2>, 6> derivative[cell_points];
  double weight[cell_points];

  Shapes() {
    const auto& rule = core::triangle_rule(4);
    for (int q = 0; q < cell_points; ++q) {
      value[q] = core::triangle_shape(rule[q].a, rule[q].b);
      derivative[q] = core::triangle_shape_derivative(rule[q].a, rule[q].b);
      weight[q] = rule[q].weight;
    }
  }
};

const Shapes& shapes() {
  static const Shapes table;
  return table;
}

/// Position at a quadrature point and its derivatives on the reference cell.
struct Mapped {
  VectorizedArray position[dim], jacobian[dim][2], determinant;
};

[[gnu::always_inline]] inline void map_point(const Shapes& shapes, int q, const NodeVectors& x, Mapped& at) {
  for (int a = 0; a < dim; ++a) {
    at.position[a] = shapes.value[q][0] * x.at[0][a];
    for (int d = 0; d < 2; ++d) at.jacobian[a][d] = shapes.derivative[q][0][d] * x.at[0][a];
    for (int i = 1; i < 6; ++i) {
      at.position[a] += shapes.value[q][i] * x.at[i][a];
      for (int d = 0; d < 2; ++d) at.jacobian[a][d] += shapes.derivative[q][i][d] * x.at[i][a];
    }
  }
  at.determinant = at.jacobian[0][0] * at.jacobian[1][1] - at.jacobian[0][1] * at.jacobian[1][0];
}

/// Depth, linear in r, and whether there are rings (1 or 0).
struct Measure {
  double at_axis, growth, rings;

  explicit Measure(core::Geometry geometry)
      : at_axis(core::depth(geometry, Point::Zero())),
        growth(core::depth(geometry, Point::Ones()) - at_axis),
        rings(core::hoop(geometry, Point::Ones())) {}
};

[[gnu::always_inline]] inline void set_volume(const Mapped& mapped, double weight, const Measure& measure,
                                              VectorizedArray& volume) {
  volume = weight * mapped.determinant * (measure.at_axis + measure.growth * mapped.position[0]);
}

[[gnu::target_clones("avx2", "default")]] void map_batch(const Shapes& shapes, const BatchNodes& nodes,
                                                         const double* values, const Measure& measure,
                                                         CellGeometry::AtPoint* at) {
  NodeVectors x;
  gather(nodes, values, x);
  for (int q = 0; q < cell_points; ++q) {
    Mapped mapped;
    map_point(shapes, q, x, mapped);
    const auto& jacobian = mapped.jacobian;
    const VectorizedArray s = 1 / mapped.determinant;
    const VectorizedArray da_dr = s * jacobian[1][1], da_dz = -s * jacobian[0][1];
    const VectorizedArray db_dr = -s * jacobian[1][0], db_dz = s * jacobian[0][0];
    for (int i = 0; i < 6; ++i) {
      vectorized(at[q].gradient[i][0]) = shapes.derivative[q][i][0] * da_dr + shapes.derivative[q][i][1] * db_dr;
      vectorized(at[q].gradient[i][1]) = shapes.derivative[q][i][0] * da_dz + shapes.derivative[q][i][1] * db_dz;
    }
    for (int a = 0; a < dim; ++a) vectorized(at[q].position[a]) = mapped.position[a];
    set_volume(mapped, shapes.weight[q], measure, vectorized(at[q].volume));
    vectorized(at[q].hoop) = measure.rings / (1 - measure.rings + measure.rings * mapped.position[0]);
  }
}

/// Integral of the velocity over each of the cells, m4/s.
[[gnu::target_clones("avx2", "default")]] void integrate_batch(const Shapes& shapes, const BatchNodes& nodes,
                                                               const double* values, const double* velocity,
                                                               const Measure& measure,
                                                               std::array<BatchArray, dim>& integral) {
  NodeVectors x, v;
  gather(nodes, values, x);
  gather(nodes, velocity, v);
  VectorizedArray sum[dim]{};
  for (int q = 0; q < cell_points; ++q) {
    Mapped mapped;
    map_point(shapes, q, x, mapped);
    VectorizedArray volume;
    set_volume(mapped, shapes.weight[q], measure, volume);
    for (int a = 0; a < dim; ++a) {
      VectorizedArray at_point = shapes.value[q][0] * v.at[0][a];
      for (int i = 1; i < 6; ++i) at_point += shapes.value[q][i] * v.at[i][a];
      sum[a] += volume * at_point;
    }
  }
  for (int a = 0; a < dim; ++a) vectorized(integral[a]) = sum[a];
}

}  // namespace

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry) {
  CellGeometry result;
  result.cells = mesh.cell_count();
  result.point.resize(std::size_t(result.batches()) * cell_points);
  const Measure measure(geometry);
  for (Index batch = 0; batch < result.batches(); ++batch)
    map_batch(shapes(), {mesh, batch}, coordinates(mesh), measure, &result.point[std::size_t(batch) * cell_points]);
  return result;
}

Point integral(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity) {
  Point sum = Point::Zero();
  std::array<BatchArray, dim> part;
  const Measure measure(geometry);
  for (Index first = 0; first < mesh.cell_count(); first += batch_size) {
    integrate_batch(shapes(), {mesh, first / batch_size}, coordinates(mesh), velocity.data(), measure, part);
    for (int a = 0; a < dim; ++a) sum[a] += part[a].head(std::min(batch_size, mesh.cell_count() - first)).sum();
  }
  return sum;
}

const std::array<std::array<double, 6>, cell_points>& shapes_at_points() {
  static const auto table = [] {
    std::array<std::array<double, 6>, cell_points> values;
    std::copy_n(shapes().value, cell_points, values.begin());
    return values;
  }();
  return table;
}

BatchVelocity batch_velocity(const core::Mesh& mesh, const CellGeometry& geometry, Index batch,
                             const Eigen::VectorXd& velocity) {
  BatchVelocity result;
  const auto at = [&](Index lane) -> const std::array<Index, 6>& { return mesh.cells()[geometry.cell(batch, lane)]; };
  const auto &first = at(0), &second = at(1), &third = at(2), &fourth = at(3);
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a)
      vectorized(result[i][a]) = VectorizedArray{velocity[dim * first[i] + a], velocity[dim * second[i] + a],
                                                 velocity[dim * third[i] + a], velocity[dim * fourth[i] + a]};
  return result;
}

[[gnu::target_clones("avx2", "default")]] BatchArray squared_rate(const CellGeometry::AtPoint& at, int q,
                                                                  const BatchVelocity& velocity) {
  const auto& shape = shapes_at_points()[q];
  VectorizedArray rr{}, zz{}, shear{}, radial{};
  for (int i = 0; i < 6; ++i) {
    const VectorizedArray &r = vectorized(velocity[i][0]), &z = vectorized(velocity[i][1]);
    const VectorizedArray &along_r = vectorized(at.gradient[i][0]), &along_z = vectorized(at.gradient[i][1]);
    rr += r * along_r;
    zz += z * along_z;
    shear += r * along_z + z * along_r;
    radial += shape[i] * r;
  }
  const VectorizedArray ring = vectorized(at.hoop) * radial;
  BatchArray result;
  vectorized(result) = rr * rr + zz * zz + 0.5 * shear * shear + ring * ring;
  return result;
}

}  // namespace parison::flow
