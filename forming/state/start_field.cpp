// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/start_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "remesh/transfer/mass_matrix.hpp"
#include "remesh/transfer/transfer.hpp"

namespace parison::forming {

using core::Index;
using core::Mesh;

namespace {

/// The middles of the `divisions` squared equal parts of the reference triangle.
std::vector<core::TriangleRulePoint> fine_rule(int divisions) {
  std::vector<core::TriangleRulePoint> rule;
  const double side = 1.0 / divisions, weight = 0.5 * side * side;
  for (int i = 0; i < divisions; ++i)
    for (int k = 0; k + i < divisions; ++k) {
      rule.push_back({(i + 1.0 / 3) * side, (k + 1.0 / 3) * side, weight});
      if (i + k + 1 < divisions) rule.push_back({(i + 2.0 / 3) * side, (k + 2.0 / 3) * side, weight});
    }
  return rule;
}

/// Calls visit(cell, point, value on the mesh, value of the function).
template <typename Visit>
void for_each_point(const Mesh& mesh, core::Geometry geometry, int divisions, const Eigen::VectorXd& nodal,
                    const PlacedTemperature& function, const Visit& visit) {
  const auto rule = fine_rule(divisions);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const core::TriangleRulePoint& at : rule) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      double value = 0;
      for (int k = 0; k < 6; ++k) value += point.shape[k] * nodal[mesh.cells()[cell][k]];
      visit(cell, point, value, function(point.position));
    }
}

Eigen::VectorXd at_nodes(const Mesh& mesh, const PlacedTemperature& function) {
  Eigen::VectorXd result(mesh.node_count());
  for (Index node = 0; node < mesh.node_count(); ++node) result[node] = function(mesh.nodes[node]);
  return result;
}

/// Edge of the equilateral triangle with the area of a cell's chords.
double edge_of(const Mesh& mesh, const std::array<Index, 6>& cell) {
  const core::Point &a = mesh.nodes[cell[0]], u = mesh.nodes[cell[1]] - a, v = mesh.nodes[cell[2]] - a;
  return std::sqrt(2 / std::sqrt(3.0) * std::abs(u[0] * v[1] - u[1] * v[0]));
}

}  // namespace

double FieldMisfit::share() const {
  double sum = 0;
  for (const double part : cell) sum += part;
  return variation > 0 ? sum / variation : 0;
}

FieldMisfit misfit(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal,
                   const PlacedTemperature& function) {
  constexpr int divisions = 3;
  FieldMisfit result;
  result.cell.assign(mesh.cells().size(), 0);
  std::vector<std::pair<double, double>> values;  // with their volumes
  double sum = 0, volume = 0;
  for_each_point(mesh, geometry, divisions, nodal, function,
                 [&](Index cell, const core::CellPoint& point, double value, double wanted) {
                   result.cell[cell] += std::abs(value - wanted) * point.volume;
                   values.emplace_back(wanted, point.volume);
                   sum += wanted * point.volume;
                   volume += point.volume;
                 });
  constexpr double round_off = 1e-10;
  for (const auto& [value, part] : values) result.variation += std::abs(value - sum / volume) * part;
  if (result.variation < round_off * std::abs(sum)) result.variation = 0;
  return result;
}

std::vector<double> fitting_sizes(const Mesh& mesh, const FieldMisfit& misfit) {
  constexpr double most = 2;
  std::vector<double> sizes(mesh.cells().size());
  const double each = start_field_tolerance * misfit.variation / double(mesh.cells().size());
  for (std::size_t cell = 0; cell < sizes.size(); ++cell) {
    const double factor = misfit.cell[cell] > 0 ? std::cbrt(each / misfit.cell[cell]) : most;
    sizes[cell] = edge_of(mesh, mesh.cells()[cell]) * std::clamp(factor, 1 / most, most);
  }
  return sizes;
}

Eigen::VectorXd fitted_field(const Mesh& mesh, core::Geometry geometry, const PlacedTemperature& function,
                             const std::function<double(double)>& heat) {
  constexpr int divisions = 8;
  const Eigen::VectorXd interpolated = at_nodes(mesh, function);
  if (misfit(mesh, geometry, interpolated, function).share() <= start_field_tolerance) return interpolated;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh.node_count());
  double content = 0, lowest = interpolated.minCoeff(), highest = interpolated.maxCoeff();
  for_each_point(mesh, geometry, divisions, interpolated, function,
                 [&](Index cell, const core::CellPoint& point, double value, double wanted) {
                   for (int k = 0; k < 6; ++k)
                     load[mesh.cells()[cell][k]] += point.shape[k] * (wanted - value) * point.volume;
                   content += heat(wanted) * point.volume;
                   lowest = std::min(lowest, wanted);
                   highest = std::max(highest, wanted);
                 });
  const remesh::MassMatrix mass(mesh, geometry);
  remesh::Carried carried;
  carried.value = mass.solve(mass.multiply(interpolated) + load, interpolated);
  carried.low = Eigen::VectorXd::Constant(carried.value.size(), lowest);
  carried.high = Eigen::VectorXd::Constant(carried.value.size(), highest);
  carried.lowest = lowest;
  carried.highest = highest;
  carried.value = carried.value.cwiseMax(carried.low).cwiseMin(carried.high);
  const auto content_of = [&](const Eigen::VectorXd& field) { return core::integral(mesh, geometry, field, heat); };
  return remesh::restore_content(carried, content_of, content);
}

}  // namespace parison::forming
