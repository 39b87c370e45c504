// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/temperature_table_text.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/case/units.hpp"
#include "core/mesh/element.hpp"

namespace parison::forming {
namespace {

using core::Index;
using core::Point;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Places at equal distances along r and along z.
struct Grid {
  Point low, step;
  int across, along;

  int count() const { return across * along; }
  int index(int i, int k) const { return k * across + i; }
  Point at(int i, int k) const { return low + Point(i * step[0], k * step[1]); }
};

Grid grid_around(const core::Mesh& mesh) {
  constexpr double places = 400;
  Point low = mesh.nodes.front(), high = low;
  for (const Point& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  const Point size = high - low;
  const double spacing = std::sqrt(size[0] * size[1] / places);
  const auto cells = [&](double length) { return std::max(2, static_cast<int>(std::ceil(length / spacing))); };
  const int across = cells(size[0]), along = cells(size[1]);
  return {low, Point(size[0] / across, size[1] / along), across + 1, along + 1};
}

/// Adds weight (w.x - value)^2 to a sum of squares.
void add_square(const std::vector<std::pair<int, double>>& row, double value, double weight, Entries& matrix,
                Eigen::VectorXd& right) {
  for (const auto& [i, a] : row) {
    right[i] += weight * a * value;
    for (const auto& [k, b] : row) matrix.emplace_back(i, k, weight * a * b);
  }
}

/// The four places around a point and their bilinear weights.
std::vector<std::pair<int, double>> around(const Grid& grid, const Point& x) {
  const Point in = (x - grid.low).cwiseQuotient(grid.step);
  const int i = std::clamp(static_cast<int>(in[0]), 0, grid.across - 2);
  const int k = std::clamp(static_cast<int>(in[1]), 0, grid.along - 2);
  const double a = in[0] - i, b = in[1] - k;
  return {{grid.index(i, k), (1 - a) * (1 - b)},
          {grid.index(i + 1, k), a * (1 - b)},
          {grid.index(i, k + 1), (1 - a) * b},
          {grid.index(i + 1, k + 1), a * b}};
}

/// The field itself, by its values at the nodes and inside the cells.
void add_field(const Grid& grid, const core::Mesh& mesh, const Eigen::VectorXd& temperature, Entries& matrix,
               Eigen::VectorXd& right) {
  for (Index node = 0; node < mesh.node_count(); ++node)
    add_square(around(grid, mesh.nodes[node]), temperature[node], 1, matrix, right);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const auto& rule : core::triangle_rule(4)) {
      const auto point = core::map_cell_point(mesh, cell, core::Geometry::planar, rule);
      double value = 0;
      for (int i = 0; i < 6; ++i) value += point.shape[i] * temperature[mesh.cells()[cell][i]];
      add_square(around(grid, point.position), value, 1, matrix, right);
    }
}

/// Small second differences, which decide only beyond the body.
void add_smoothness(const Grid& grid, Entries& matrix, Eigen::VectorXd& right) {
  constexpr double weight = 1e-3;
  for (int k = 0; k < grid.along; ++k)
    for (int i = 0; i < grid.across; ++i) {
      if (i + 2 < grid.across)
        add_square({{grid.index(i, k), 1}, {grid.index(i + 1, k), -2}, {grid.index(i + 2, k), 1}}, 0, weight, matrix,
                   right);
      if (k + 2 < grid.along)
        add_square({{grid.index(i, k), 1}, {grid.index(i, k + 1), -2}, {grid.index(i, k + 2), 1}}, 0, weight, matrix,
                   right);
    }
}

}  // namespace

std::string temperature_table_text(const core::Mesh& mesh, const Eigen::VectorXd& temperature) {
  constexpr double mm = 1e3;
  const Grid grid = grid_around(mesh);
  Entries entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(grid.count());
  add_field(grid, mesh, temperature, entries, right);
  add_smoothness(grid, entries, right);
  Eigen::SparseMatrix<double> matrix(grid.count(), grid.count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd values = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
  // Beyond the body no place is hotter or colder than the body.
  const double lowest = temperature.minCoeff(), highest = temperature.maxCoeff();
  std::string text = "r_mm,z_mm,T_degC\n";
  for (int k = 0; k < grid.along; ++k)
    for (int i = 0; i < grid.across; ++i) {
      const Point x = mm * grid.at(i, k);
      text += fmt::format("{:.6g},{:.6g},{:.1f}\n", x[0], x[1],
                          std::clamp(values[grid.index(i, k)], lowest, highest) - core::zero_celsius);
    }
  return text;
}

}  // namespace parison::forming
