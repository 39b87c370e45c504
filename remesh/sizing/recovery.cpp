// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/sizing/recovery.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/mesh/element.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr int terms = 6;           ///< of a complete quadratic polynomial
constexpr std::size_t fewest = 5;  ///< cells of a patch; a smaller one is extended by the neighbouring cells
/// A derivative counts as zero where the field changes by less than this part of its largest value over the body.
constexpr double rounding = 1e-9;
constexpr double derivative_order = 2;  ///< order of convergence of the derivative with quadratic cells

template <int n>
using Values = Eigen::Matrix<double, n, 1>;

/// Quadratic polynomial that fits the samples of the derivative in the cells around a vertex by least squares.
template <int n>
struct Patch {
  Point centre;
  double size = 1;
  Eigen::Matrix<double, terms, n> factors;

  static Values<terms> basis(const Point& x) { return {1, x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1]}; }
  Values<n> at(const Point& x) const { return factors.transpose() * basis((x - centre) / size); }
};

template <int n>
struct Sample {
  Point at;
  Values<n> value;
};

/// The cells at each vertex.
std::vector<std::vector<Index>> cells_at_vertices(const Mesh& mesh) {
  std::vector<std::vector<Index>> around(mesh.vertex_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int k = 0; k < 3; ++k) around[mesh.cells()[cell][k]].push_back(cell);
  return around;
}

/// The cells of the patch at a vertex: those around it and, where these are too few, the ones around their vertices.
std::vector<Index> patch_cells(const Mesh& mesh, const std::vector<std::vector<Index>>& around, Index vertex) {
  std::vector<Index> cells = around[vertex];
  for (int ring = 0; ring < 2 && cells.size() < fewest; ++ring) {
    std::vector<Index> more;
    for (const Index cell : cells)
      for (int k = 0; k < 3; ++k) {
        const auto& there = around[mesh.cells()[cell][k]];
        more.insert(more.end(), there.begin(), there.end());
      }
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    cells = std::move(more);
  }
  return cells;
}

template <int n>
Patch<n> fit(const Point& centre, const std::vector<Index>& cells,
             const std::vector<std::array<Sample<n>, 3>>& samples) {
  Patch<n> patch{centre, 0, {}};
  for (const Index cell : cells)
    for (const auto& sample : samples[cell]) patch.size = std::max(patch.size, (sample.at - centre).norm());
  Eigen::Matrix<double, terms, terms> normal = Eigen::Matrix<double, terms, terms>::Zero();
  Eigen::Matrix<double, terms, n> load = Eigen::Matrix<double, terms, n>::Zero();
  for (const Index cell : cells)
    for (const auto& sample : samples[cell]) {
      const Values<terms> basis = Patch<n>::basis((sample.at - centre) / patch.size);
      normal += basis * basis.transpose();
      load += basis * sample.value.transpose();
    }
  normal.diagonal().array() += 1e-12 * normal.trace();  // a single row of cells does not determine all terms
  patch.factors = normal.ldlt().solve(load);
  return patch;
}

/// The recovered derivative at the nodes: at a vertex from its patch, at a mid-side node the mean from both ends'
/// patches.
template <int n>
std::vector<Values<n>> recovered(const Mesh& mesh, const std::vector<std::array<Sample<n>, 3>>& samples) {
  const auto around = cells_at_vertices(mesh);
  std::vector<Patch<n>> patches;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    patches.push_back(fit<n>(mesh.nodes[v], patch_cells(mesh, around, v), samples));
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

/// Samples `derivative(cell, point)` at the three points of the rule of degree 2, where derivatives of quadratic cells
/// are most accurate (J. Barlow, Int. J. Numer. Meth. Engng 10 (1976) 243-251). `largest` is the field's largest value.
template <int n, class Derivative>
DerivativeError estimate(const Mesh& mesh, core::Geometry geometry, double largest, const Derivative& derivative) {
  std::vector<std::array<Sample<n>, 3>> samples(mesh.cells().size());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int k = 0; k < 3; ++k) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, core::triangle_rule(2)[k]);
      samples[cell][k] = {point.position, derivative(cell, point)};
    }
  const auto nodal = recovered<n>(mesh, samples);
  DerivativeError error{Eigen::VectorXd::Zero(mesh.cell_count())};
  double volume = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& at : core::triangle_rule(5)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      Values<n> better = Values<n>::Zero();
      for (int i = 0; i < 6; ++i) better += point.shape[i] * nodal[mesh.cells()[cell][i]];
      error.cell[cell] += point.volume * (better - derivative(cell, point)).squaredNorm();
      error.derivative += point.volume * better.squaredNorm();
      volume += point.volume;
    }
  if (error.derivative <= volume * std::pow(rounding * largest / extent(mesh), 2))
    return {Eigen::VectorXd::Zero(mesh.cell_count())};
  error.cell = error.cell.cwiseSqrt();
  error.derivative = std::sqrt(error.derivative);
  return error;
}

/// Edge of the equilateral triangle with the area of a cell's chords.
double edge_of(const Mesh& mesh, const std::array<Index, 6>& cell) {
  const Point &a = mesh.nodes[cell[0]], u = mesh.nodes[cell[1]] - a, v = mesh.nodes[cell[2]] - a;
  return std::sqrt(2 / std::sqrt(3.0) * std::abs(u[0] * v[1] - u[1] * v[0]));
}

}  // namespace

DerivativeError gradient_error(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal) {
  return estimate<core::dim>(mesh, geometry, nodal.lpNorm<Eigen::Infinity>(),
                             [&](Index cell, const core::CellPoint& point) {
                               Point gradient = Point::Zero();
                               for (int i = 0; i < 6; ++i) gradient += nodal[mesh.cells()[cell][i]] * point.gradient[i];
                               return gradient;
                             });
}

DerivativeError rate_error(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& velocity) {
  return estimate<4>(mesh, geometry, velocity.lpNorm<Eigen::Infinity>(), [&](Index cell, const core::CellPoint& point) {
    Values<4> rate = Values<4>::Zero();  // rr, zz, sqrt 2 rz (which stands for rz and zr), hoop
    for (int i = 0; i < 6; ++i) {
      const auto v = velocity.segment<core::dim>(core::dim * mesh.cells()[cell][i]);
      const Point& g = point.gradient[i];
      rate += Values<4>(v[0] * g[0], v[1] * g[1], (v[0] * g[1] + v[1] * g[0]) / std::sqrt(2.0),
                        v[0] * point.shape[i] * core::hoop(geometry, point.position));
    }
    return rate;
  });
}

Eigen::VectorXd equidistributing_sizes(const Mesh& mesh, const DerivativeError& error, double target) {
  // In a finer mesh the error of each cell is proportional to h^(p + 1), and the number of cells to 1/h^2.
  constexpr double p = derivative_order;
  const double sum = error.cell.array().pow(2 / (p + 1)).sum();
  const double whole = target * error.derivative;
  Eigen::VectorXd sizes = Eigen::VectorXd::Constant(mesh.cell_count(), std::numeric_limits<double>::infinity());
  if (!(sum > 0 && whole > 0)) return sizes;
  const double each = std::pow(whole * whole / sum, (p + 1) / (2 * p));
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (error.cell[cell] > 0)
      sizes[cell] = edge_of(mesh, mesh.cells()[cell]) * std::pow(each / error.cell[cell], 1 / (p + 1));
  return sizes;
}

}  // namespace parison::remesh
