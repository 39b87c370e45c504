// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/sizing/recovery.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/math/numbers.hpp"
#include "core/mesh/cell_batch.hpp"
#include "remesh/mesher/fans.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;
using core::VectorizedArray;

namespace {

constexpr int terms = 6;           ///< of a complete quadratic polynomial
constexpr int n = 4;               ///< components of a rate of deformation
constexpr std::size_t fewest = 5;  ///< cells of a patch; a smaller one is extended by the neighbouring cells

template <int size>
using Values = Eigen::Matrix<double, size, 1>;

/// Quadratic polynomial that fits the samples of the derivative in the cells around a vertex by least squares.
struct Patch {
  Point centre;
  double size = 1;
  Eigen::Matrix<double, terms, n> factors;

  static Values<terms> basis(const Point& x) { return {1, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1]}; }
  Values<n> at(const Point& x) const { return factors.transpose() * basis((x - centre) / size); }
};

/// Nodes of a batch's cells and where they are.
struct BatchNodes {
  core::BatchIndices<6> index;
  core::NodeVectors position;

  BatchNodes(const Mesh& mesh, Index batch) {
    core::set_nodes(mesh.cells(), batch, index);
    core::gather(mesh.nodes.front().data(), index, position);
  }
};

struct Sample {
  Point at;
  Values<n> value;
};

/// Appends the cells around a vertex.
void append_cells(const Fans& fans, Index vertex, std::vector<Index>& cells) {
  cells.insert(cells.end(), fans.cell.begin() + fans.start[vertex], fans.cell.begin() + fans.start[vertex + 1]);
}

/// Sets `cells` to those of the patch at a vertex: around it and, where these are too few, around their vertices.
void set_patch_cells(const Mesh& mesh, const Fans& fans, Index vertex, std::vector<Index>& cells) {
  cells.clear();
  append_cells(fans, vertex, cells);
  for (int ring = 0; ring < 2 && cells.size() < fewest; ++ring) {
    std::vector<Index> more;
    for (const Index cell : cells)
      for (int k = 0; k < 3; ++k) append_cells(fans, mesh.cells()[cell][k], more);
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    cells = std::move(more);
  }
}

Patch fit(const Point& centre, const std::vector<Index>& cells, const std::vector<std::array<Sample, 3>>& samples) {
  Patch patch{centre, 0, {}};
  for (const Index cell : cells)
    for (const auto& sample : samples[cell]) patch.size = std::max(patch.size, (sample.at - centre).norm());
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();  // its lower triangle
  Eigen::Matrix<double, terms, n> load = Eigen::Matrix<double, terms, n>::Zero();
  for (const Index cell : cells)
    for (const auto& sample : samples[cell]) {
      const Values<terms> basis = Patch::basis((sample.at - centre) / patch.size);
      for (int j = 0; j < terms; ++j)
        for (int i = j; i < terms; ++i) normal(i, j) += basis[i] * basis[j];
      for (int c = 0; c < n; ++c) load.col(c) += sample.value[c] * basis;
    }
  normal.diagonal().array() += 1e-12 * normal.trace();  // a single row of cells does not determine all terms
  patch.factors = normal.ldlt().solve(load);
  return patch;
}

/// The recovered derivative at the nodes: at a vertex from its patch, at a mid-side node the mean from both ends'
/// patches.
std::vector<Values<n>> recovered(const Mesh& mesh, const std::vector<std::array<Sample, 3>>& samples) {
  const Fans fans = fans_of(mesh);
  std::vector<Patch> patches;
  patches.reserve(mesh.vertex_count());
  std::vector<Index> cells;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    set_patch_cells(mesh, fans, v, cells);
    patches.push_back(fit(mesh.nodes[v], cells, samples));
  }
  std::vector<Values<n>> nodal(mesh.nodes.size());
  for (Index v = 0; v < mesh.vertex_count(); ++v) nodal[v] = patches[v].at(mesh.nodes[v]);
  for (const auto& cell : mesh.cells())
    for (int k = 0; k < 3; ++k) {
      const Point& x = mesh.nodes[cell[3 + k]];
      nodal[cell[3 + k]] = 0.5 * (patches[cell[k]].at(x) + patches[cell[(k + 1) % 3]].at(x));
    }
  return nodal;
}

double extent(const Mesh& mesh) {
  Point low = mesh.nodes[0], high = low;
  for (const Point& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return (high - low).norm();
}

/// Shape functions of a cell at the points of a quadrature rule.
template <int points>
core::CellShapes<6, points> shapes_at(const std::vector<core::TriangleRulePoint>& rule) {
  core::CellShapes<6, points> shapes;
  for (int q = 0; q < points; ++q) core::set_shapes(rule[q].a, rule[q].b, q, shapes);
  return shapes;
}

/// What the derivatives of a batch of cells are computed from, at one point.
struct BatchPoint {
  core::MappedPoint<VectorizedArray> mapped;
  std::array<std::array<VectorizedArray, core::dim>, 6> gradient;  ///< 1/m
};

template <int points>
void set_point(const core::CellShapes<6, points>& shapes, int q, const core::NodeVectors& x, BatchPoint& at) {
  core::map_point(shapes, q, x, at.mapped);
  core::set_gradients(shapes, q, at.mapped, at.gradient);
}

/// Rate of deformation of nodal velocities: rr, zz, sqrt 2 rz (which stands for rz and zr), hoop.
struct Rate {
  core::Geometry geometry;
  const Eigen::VectorXd& velocity;

  core::NodeVectors values(const BatchNodes& nodes) const {
    core::NodeVectors at;
    core::gather(velocity.data(), nodes.index, at);
    return at;
  }
  template <int points>
  void set(const core::CellShapes<6, points>& shapes, int q, const BatchPoint& at, const core::NodeVectors& v,
           std::array<VectorizedArray, n>& rate) const {
    const bool round = geometry == core::Geometry::axisymmetric;
    rate = {};
    const VectorizedArray hoop = round ? 1 / at.mapped.position[0] : VectorizedArray{};
    for (int i = 0; i < 6; ++i) {
      const auto& g = at.gradient[i];
      rate[0] += v[0][i] * g[0];
      rate[1] += v[1][i] * g[1];
      rate[2] += (v[0][i] * g[1] + v[1][i] * g[0]) / std::sqrt(2.0);
      rate[3] += v[0][i] * shapes.value(q, i) * hoop;
    }
  }
};

/// The derivative at the three points of the rule of degree 2, where derivatives of quadratic cells are most accurate
/// (J. Barlow, Int. J. Numer. Meth. Engng 10 (1976) 243-251).
std::vector<std::array<Sample, 3>> sampled(const Mesh& mesh, const Rate& rate) {
  static const core::CellShapes<6, 3> shapes = shapes_at<3>(core::triangle_rule(2));
  std::vector<std::array<Sample, 3>> samples(mesh.cells().size());
  const Index count = mesh.cell_count();
  for (Index batch = 0; batch < core::batch_count(count); ++batch) {
    const BatchNodes nodes(mesh, batch);
    const auto values = rate.values(nodes);
    for (int q = 0; q < 3; ++q) {
      BatchPoint at;
      set_point(shapes, q, nodes.position, at);
      std::array<VectorizedArray, n> value;
      rate.set(shapes, q, at, values, value);
      for (int lane = 0; lane < core::filled_lanes(count, batch); ++lane) {
        Sample& sample = samples[batch * core::batch_size + lane][q];
        sample.at = {at.mapped.position[0][lane], at.mapped.position[1][lane]};
        for (int c = 0; c < n; ++c) sample.value[c] = value[c][lane];
      }
    }
  }
  return samples;
}

/// The sum of squares, in pairs of every second one.
VectorizedArray squared_norm(const std::array<VectorizedArray, n>& x) {
  return (x[0] * x[0] + x[2] * x[2]) + (x[1] * x[1] + x[3] * x[3]);
}

/// Adds the integrals over a batch of cells of the squared difference of a rate from the recovered one, and of
/// the latter's square, to `error`.
double add_batch(const Mesh& mesh, const std::vector<Values<n>>& nodal, Index batch, const Rate& rate,
                 DerivativeError& error) {
  static const auto& rule = core::triangle_rule(5);
  static const core::CellShapes<6, 7> shapes = shapes_at<7>(rule);
  const core::Depth depth(rate.geometry);
  const BatchNodes nodes(mesh, batch);
  const auto values = rate.values(nodes);
  std::array<std::array<VectorizedArray, 6>, n> better_at;
  for (int i = 0; i < 6; ++i)
    for (int c = 0; c < n; ++c)
      for (int lane = 0; lane < core::batch_size; ++lane) better_at[c][i][lane] = nodal[nodes.index[i][lane]][c];
  std::array<VectorizedArray, 7> difference, square, volume;
  for (int q = 0; q < 7; ++q) {
    BatchPoint at;
    set_point(shapes, q, nodes.position, at);
    std::array<VectorizedArray, n> found, better;
    rate.set(shapes, q, at, values, found);
    for (int c = 0; c < n; ++c) {
      core::interpolate(shapes.value, q, better_at[c], better[c]);
      found[c] = better[c] - found[c];
    }
    depth.set(at.mapped.position[0], volume[q]);
    volume[q] = (rule[q].weight * at.mapped.determinant) * volume[q];
    difference[q] = volume[q] * squared_norm(found);
    square[q] = volume[q] * squared_norm(better);
  }
  double whole = 0;
  const Index count = mesh.cell_count();
  for (int lane = 0; lane < core::filled_lanes(count, batch); ++lane)
    for (int q = 0; q < 7; ++q) {
      error.cell[batch * core::batch_size + lane] += difference[q][lane];
      error.derivative += square[q][lane];
      whole += volume[q][lane];
    }
  return whole;
}

}  // namespace

DerivativeError rate_error(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity) {
  const Rate rate{geometry, velocity};
  const auto nodal = recovered(mesh, sampled(mesh, rate));
  DerivativeError error{Eigen::VectorXd::Zero(mesh.cell_count())};
  double volume = 0;
  for (Index batch = 0; batch < core::batch_count(mesh.cell_count()); ++batch)
    volume += add_batch(mesh, nodal, batch, rate, error);
  // Zero where the field changes by round-off over the body.
  const double largest = velocity.lpNorm<Eigen::Infinity>();
  if (error.derivative <= volume * std::pow(core::round_off * largest / extent(mesh), 2))
    return {Eigen::VectorXd::Zero(mesh.cell_count())};
  error.cell = error.cell.cwiseSqrt();
  error.derivative = std::sqrt(error.derivative);
  return error;
}

}  // namespace parison::remesh
