// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/transfer/transfer.hpp"

#include <algorithm>
#include <utility>

#include "core/mesh/element.hpp"
#include "remesh/transfer/mass_matrix.hpp"
#include "remesh/transfer/overlay.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Sets the bounds of each value: the range of the old cell that contains it, widened by half on both sides, within the
/// extremes of the old field. Quadratic fields stay within them; overshoots next to a thermal skin are cut off.
void set_ranges(const Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal, Carried& carried) {
  carried.lowest = nodal.minCoeff(), carried.highest = nodal.maxCoeff();
  carried.low = carried.high = carried.value;
  for (Index i = 0; i < carried.value.size(); ++i) {
    const auto& cell = from.cells()[transfer.cell[i]];
    double low = nodal[cell[0]], high = low;
    for (const Index node : cell) low = std::min(low, nodal[node]), high = std::max(high, nodal[node]);
    const double slack = 0.5 * (high - low);
    carried.low[i] = std::max(carried.lowest, low - slack);
    carried.high[i] = std::min(carried.highest, high + slack);
  }
}

/// A field and the difference of its content from the wanted one.
struct TrialField {
  Eigen::VectorXd field;
  double defect;
};

/// Solves content(path(t)) = target by the secant method from t = 0, whose field is `start`, and t = first. Returns the
/// field with the smallest defect.
TrialField secant_search(const std::function<Eigen::VectorXd(double)>& path, const Content& content, double target,
                         TrialField start, double first) {
  constexpr int rounds = 12;
  constexpr double exact = 4e-16;
  TrialField best = std::move(start);
  double before = 0, defect_before = best.defect, t = first;
  for (int round = 0; round < rounds && std::abs(best.defect) > exact * std::abs(target); ++round) {
    TrialField now{path(t), 0};
    now.defect = content(now.field) - target;
    if (now.defect == defect_before) break;
    const double next = t - now.defect * (t - before) / (now.defect - defect_before);
    before = t, defect_before = now.defect, t = next;
    if (std::abs(now.defect) < std::abs(best.defect)) best = std::move(now);
  }
  return best;
}

}  // namespace

Transfer make_transfer(const Mesh& from, const Mesh& to) {
  const CellGrid grid(from);
  Transfer transfer;
  transfer.cell.reserve(to.nodes.size());
  transfer.at.reserve(to.nodes.size());
  for (const Point& x : to.nodes) {
    const CellGrid::Found found = grid.find(x);
    transfer.cell.push_back(found.cell);
    transfer.at.push_back(found.at);
  }
  return transfer;
}

Eigen::VectorXd interpolate(const Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal) {
  Eigen::VectorXd result(transfer.cell.size());
  for (Index i = 0; i < result.size(); ++i) {
    const auto shape = core::triangle_shape(transfer.at[i][0], transfer.at[i][1]);
    result[i] = 0;
    for (int k = 0; k < 6; ++k) result[i] += shape[k] * nodal[from.cells()[transfer.cell[i]][k]];
  }
  return result;
}

double mean(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal) {
  // Integrating the difference from one nodal value gives a uniform field its exact mean.
  const double base = nodal[0];
  double content = 0, volume = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      double value = 0;
      for (int k = 0; k < 6; ++k) value += point.shape[k] * (nodal[mesh.cells()[cell][k]] - base);
      content += value * point.volume;
      volume += point.volume;
    }
  return base + content / volume;
}

Carried project(const Mesh& from, const Mesh& to, core::Geometry geometry, const Transfer& transfer,
                const Eigen::VectorXd& nodal, std::vector<bool> is_given, const Eigen::VectorXd& given) {
  const MassMatrix mass(to, geometry);
  Eigen::VectorXd start = interpolate(from, transfer, nodal);
  const auto for_each_given = [&](const auto& what) {
    for (std::size_t i = 0; i < is_given.size(); ++i)
      if (is_given[i]) what(static_cast<Index>(i));
  };
  for_each_given([&](Index i) { start[i] = given[i]; });
  // Where the chords of old cells lie on each other both cells count: of a small difference, that does no harm.
  Carried carried;
  carried.value = mass.solve(mass.multiply(start) + overlay_load(from, to, geometry, nodal, start), start, is_given);
  set_ranges(from, transfer, nodal, carried);
  for_each_given([&](Index i) { carried.low[i] = carried.high[i] = given[i]; });
  carried.value = carried.value.cwiseMax(carried.low).cwiseMin(carried.high);
  return carried;
}

Eigen::VectorXd restore_content(const Carried& carried, const Content& content, double target) {
  constexpr double kept = 1e-13;
  TrialField start{carried.value, 0};
  const double carried_content = content(start.field),
               derivative = content((start.field.array() + 1).matrix()) - carried_content;
  start.defect = carried_content - target;
  const auto shifted = [&](double t) -> Eigen::VectorXd {
    return (carried.value.array() + t).matrix().cwiseMax(carried.low).cwiseMin(carried.high);
  };
  TrialField near = secant_search(shifted, content, target, start, -start.defect / derivative);
  if (std::abs(near.defect) <= kept * std::abs(target)) return near.field;
  // The bounds do not admit the wanted content: every value moves by the same fraction of its distance to an old
  // extreme.
  const double limit = start.defect < 0 ? carried.highest : carried.lowest;
  const auto drawn = [&](double t) -> Eigen::VectorXd {
    const double fraction = std::clamp(t, 0.0, 1.0);
    return ((1 - fraction) * carried.value.array() + fraction * limit)
        .cwiseMax(carried.lowest)
        .cwiseMin(carried.highest);
  };
  const double room = content(Eigen::VectorXd::Constant(start.field.size(), limit)) - carried_content;
  const TrialField far = secant_search(drawn, content, target, start, room != 0 ? -start.defect / room : 0.0);
  return std::abs(far.defect) < std::abs(near.defect) ? far.field : near.field;
}

Eigen::VectorXd transfer_conserving(const Mesh& from, const Mesh& to, core::Geometry geometry, const Transfer& transfer,
                                    const Eigen::VectorXd& nodal) {
  const auto content = [&](const Eigen::VectorXd& field) { return mean(to, geometry, field); };
  return restore_content(project(from, to, geometry, transfer, nodal), content, mean(from, geometry, nodal));
}

}  // namespace parison::remesh
