// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/cell_geometry.hpp"

#include "core/mesh/element.hpp"

namespace parison::flow {

using core::dim;

namespace {

using Shapes = core::CellShapes<6>;
using MappedPoint = core::MappedPoint<VectorizedArray>;

/// Weights of triangle_rule(4).
using RuleWeights = std::array<double, cell_points>;
const RuleWeights& rule_weights() {
  static const RuleWeights weights = [] {
    RuleWeights made;
    for (int q = 0; q < cell_points; ++q) made[q] = core::triangle_rule(4)[q].weight;
    return made;
  }();
  return weights;
}

/// Depth, and whether there are rings (1 or 0).
struct Measure {
  core::Depth depth;
  double rings;

  explicit Measure(core::Geometry geometry) : depth(geometry), rings(core::hoop(geometry, Point::Ones())) {}
  /// Volume of a quadrature point, m3.
  [[gnu::always_inline]] void set_volume(const MappedPoint& mapped, double weight, VectorizedArray& volume) const {
    VectorizedArray depth_there;
    depth.set(mapped.position[0], depth_there);
    volume = weight * mapped.determinant * depth_there;
  }
};

[[gnu::target_clones("avx2", "default")]] void map_batch(const Shapes& shapes, const RuleWeights& weights,
                                                         const core::BatchIndices<6>& nodes, const double* coordinates,
                                                         const Measure& measure, CellGeometry::AtPoint* at) {
  core::NodeVectors x;
  core::gather(coordinates, nodes, x);
  for (int q = 0; q < cell_points; ++q) {
    MappedPoint mapped;
    core::map_point(shapes, q, x, mapped);
    core::set_gradients(shapes, q, mapped, at[q].gradient);
    at[q].position = mapped.position;
    measure.set_volume(mapped, weights[q], at[q].volume);
    at[q].hoop = measure.rings / (1 - measure.rings + measure.rings * mapped.position[0]);
  }
}

/// Integral of the velocity over each of the cells, m4/s.
[[gnu::target_clones("avx2", "default")]] void integrate_batch(const Shapes& shapes, const RuleWeights& weights,
                                                               const core::BatchIndices<6>& nodes,
                                                               const double* coordinates, const double* velocity,
                                                               const Measure& measure,
                                                               std::array<VectorizedArray, dim>& integral) {
  core::NodeVectors x, v;
  core::gather(coordinates, nodes, x);
  core::gather(velocity, nodes, v);
  VectorizedArray sum[dim]{};
  for (int q = 0; q < cell_points; ++q) {
    MappedPoint mapped;
    core::map_point(shapes, q, x, mapped);
    VectorizedArray volume, at_point;
    measure.set_volume(mapped, weights[q], volume);
    for (int a = 0; a < dim; ++a) {
      core::interpolate(shapes.value, q, v[a], at_point);
      sum[a] += volume * at_point;
    }
  }
  for (int a = 0; a < dim; ++a) integral[a] = sum[a];
}

const double* coordinates(const core::Mesh& mesh) {
  return mesh.nodes.front().data();
}

}  // namespace

CellGeometry cell_geometry(const core::Mesh& mesh, core::Geometry geometry) {
  CellGeometry result;
  result.cells = mesh.cell_count();
  result.point.resize(std::size_t(result.batches()) * cell_points);
  const Measure measure(geometry);
  core::BatchIndices<6> nodes;
  for (Index batch = 0; batch < result.batches(); ++batch) {
    core::set_nodes(mesh.cells(), batch, nodes);
    map_batch(core::cell_shapes<6>(), rule_weights(), nodes, coordinates(mesh), measure,
              &result.point[std::size_t(batch) * cell_points]);
  }
  return result;
}

Point integral(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity) {
  Point sum = Point::Zero();
  std::array<VectorizedArray, dim> part;
  const Measure measure(geometry);
  core::BatchIndices<6> nodes;
  for (Index batch = 0; batch < core::batch_count(mesh.cell_count()); ++batch) {
    core::set_nodes(mesh.cells(), batch, nodes);
    integrate_batch(core::cell_shapes<6>(), rule_weights(), nodes, coordinates(mesh), velocity.data(), measure, part);
    for (int a = 0; a < dim; ++a) sum[a] += core::sum(part[a], core::filled_lanes(mesh.cell_count(), batch));
  }
  return sum;
}

core::NodeVectors batch_velocity(const core::Mesh& mesh, Index batch, const Eigen::VectorXd& velocity) {
  core::BatchIndices<6> nodes;
  core::set_nodes(mesh.cells(), batch, nodes);
  core::NodeVectors result;
  core::gather(velocity.data(), nodes, result);
  return result;
}

[[gnu::target_clones("avx2", "default")]] void set_squared_rate(const CellGeometry::AtPoint& at, int q,
                                                                const core::NodeVectors& velocity,
                                                                VectorizedArray& squared) {
  VectorizedArray rr{}, zz{}, shear{}, radial;
  for (int i = 0; i < 6; ++i) {
    const VectorizedArray &r = velocity[0][i], &z = velocity[1][i];
    const auto& [along_r, along_z] = at.gradient[i];
    rr += r * along_r;
    zz += z * along_z;
    shear += r * along_z + z * along_r;
  }
  core::interpolate(core::cell_shapes<6>().value, q, velocity[0], radial);
  const VectorizedArray ring = at.hoop * radial;
  squared = rr * rr + zz * zz + 0.5 * shear * shear + ring * ring;
}

}  // namespace parison::flow
