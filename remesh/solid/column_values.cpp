// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/solid/column_values.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "remesh/transfer/overlay.hpp"

namespace parison::remesh {

namespace {

using core::Vector3;

/// Sums of a least-squares fit, and the range of what is fitted.
struct Fit {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd load;
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(Index first, const Eigen::Vector3d& shape, double weight, double value) {
    matrix.block<3, 3>(first, first) += weight * shape * shape.transpose();
    load.segment<3>(first) += weight * value * shape;
    include(value);
  }
  void include(double value) { low = std::min(low, value), high = std::max(high, value); }

  /// The nearest values; those that would leave the range stay at its ends, and the others are fitted once more.
  Eigen::VectorXd solve() const {
    Eigen::MatrixXd left = matrix;
    Eigen::VectorXd right = load, values;
    for (bool changed = true; changed;) {
      values = left.ldlt().solve(right);
      changed = false;
      for (Index i = 0; i < values.size(); ++i) {
        const double kept = std::clamp(values[i], low, high);
        if (std::abs(kept - values[i]) <= core::round_off * (high - low)) continue;
        right -= kept * left.col(i);
        left.row(i).setZero();
        left.col(i).setZero();
        left(i, i) = 1;
        right[i] = kept;
        changed = true;
      }
    }
    return values.cwiseMax(low).cwiseMin(high);
  }
};

/// A nodal field of a section turned about the axis.
class TurnedField {
 public:
  TurnedField(const core::Mesh& section, const Eigen::VectorXd& field)
      : section_(section), field_(field), cells_(section) {}

  double at(const Vector3& place) const {
    const auto found = cells_.find({std::hypot(place[0], place[1]), place[2]});
    const auto shape = core::triangle_shape(found.at[0], found.at[1]);
    double value = 0;
    for (int i = 0; i < 6; ++i) value += shape[i] * field_[section_.cells()[found.cell][i]];
    return value;
  }

 private:
  const core::Mesh& section_;
  const Eigen::VectorXd& field_;
  CellGrid cells_;
};

/// Shape functions of three nodes on a line.
Eigen::Vector3d line_shape(double s) {
  return {(1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)};
}

Fit fit_through(const TurnedField& field, const std::vector<Vector3>& column) {
  constexpr int samples = 12;  // of a layer
  const auto nodes = static_cast<Index>(column.size());
  Fit fit{Eigen::MatrixXd::Zero(nodes, nodes), Eigen::VectorXd::Zero(nodes)};
  for (std::size_t first = 0; first + 2 < column.size(); first += 2) {
    const auto place = [&](double s) -> Vector3 {
      const Eigen::Vector3d shape = line_shape(s);
      return shape[0] * column[first] + shape[1] * column[first + 1] + shape[2] * column[first + 2];
    };
    for (int i = 0; i < samples; ++i) {
      const double s = (i + 0.5) / samples, half = 0.5 / samples;
      fit.add(static_cast<Index>(first), line_shape(s), (place(s + half) - place(s - half)).norm(), field.at(place(s)));
    }
  }
  for (const Vector3& end : {column.front(), column.back()}) fit.include(field.at(end));
  return fit;
}

}  // namespace

Eigen::VectorXd column_values(const core::Mesh& section, const Eigen::VectorXd& field, const WallMesh& wall) {
  const TurnedField turned(section, field);
  Eigen::VectorXd result(wall.mesh.node_count());
  for (const auto& column : wall.columns) {
    std::vector<Vector3> places;
    for (const Index node : column) places.push_back(wall.mesh.nodes[static_cast<std::size_t>(node)]);
    const Eigen::VectorXd values = fit_through(turned, places).solve();
    for (std::size_t n = 0; n < column.size(); ++n) result[column[n]] = values[static_cast<Index>(n)];
  }
  return result;
}

}  // namespace parison::remesh
