// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/correction.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace parison::flow {

using core::dim;

namespace {

/// More back-substitutions than this cost more than a factorisation.
constexpr std::size_t most_handles = 40;
/// A drag that changed by less, relatively, is the same.
constexpr double same_drag = 1e-9;

core::Tensor frame_of(const NodeFrame* held) { return held ? held->frame : core::Tensor(core::Tensor::Identity()); }

bool fixes(const NodeFrame* held, int axis) { return held && held->fixed[axis]; }

/// Drag along the last column of the frame, N.s/m.
double drag_of(const Held& held, Index node) {
  const NodeFrame* frame = held.find(node);
  return frame && frame->friction_tool >= 0 ? held.drag[node] : 0.0;
}

bool same_equalities(const NodeFrame* a, const NodeFrame* b) {
  if (!a || !b) return a == b;
  if (a->friction_tool != b->friction_tool || a->equalities.size() != b->equalities.size()) return false;
  for (std::size_t i = 0; i < a->equalities.size(); ++i)
    if (a->equalities[i].candidate != b->equalities[i].candidate || a->equalities[i].normal != b->equalities[i].normal)
      return false;
  return true;
}

Point at(const Eigen::MatrixXd& values, Index node, Index column) {
  return values.block<dim, 1>(dim * node, column);
}
Point at(const Eigen::VectorXd& values, Index node) { return values.segment<dim>(dim * node); }

template <class Wanted>
std::vector<Index> cells_with(const core::Mesh& mesh, const Wanted& wanted) {
  std::vector<Index> cells;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    if (std::any_of(mesh.cells[c].begin(), mesh.cells[c].end(), wanted)) cells.push_back(c);
  return cells;
}

}  // namespace

Eigen::VectorXd unbalanced(const Problem& problem, const Held& held, const Eigen::VectorXd& load, const Iterate& iterate) {
  Eigen::VectorXd residual = load - iterate.force;
  const auto tools = driven_tools(problem);
  for (const auto& frame : held.frames) {
    if (frame.friction_tool < 0) continue;
    const Point along = frame.frame.col(dim - 1);
    const auto k = std::find(tools.begin(), tools.end(), frame.friction_tool);
    const double wall =
        k == tools.end() ? problem.tools[frame.friction_tool].velocity : iterate.driven[k - tools.begin()];
    const double slip = along.dot(at(iterate.x, frame.node) - wall * core::axis_direction());
    residual.segment<dim>(dim * frame.node) -= held.drag[frame.node] * slip * along;
  }
  return residual;
}

double imbalance(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                 Iterate& iterate) {
  const auto& mesh = *problem.mesh;
  Eigen::VectorXd size = load.cwiseAbs();
  iterate.force.setZero();
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto where = unknowns_of(mesh, c);
    const auto part = cell_product(cells.of(c), where, iterate.x);
    for (int i = 0; i < cell_unknowns; ++i) {
      iterate.force[where[i]] += part[i];
      size[where[i]] += std::abs(part[i]);
    }
  }
  Eigen::VectorXd residual = unbalanced(problem, held, load, iterate);
  for (const auto& frame : held.frames)
    for (int a = 0; a < dim; ++a)
      if (frame.fixed[a]) {
        auto there = residual.segment<dim>(dim * frame.node);
        there -= (frame.frame.col(a).dot(there) * frame.frame.col(a)).eval();
      }
  double worst = 0;
  for (Index i = 0; i < residual.size(); ++i)
    if (residual[i] != 0) worst = std::max(worst, std::abs(residual[i]) / size[i]);
  return worst;
}

void Corrector::forget() {
  system_.forget();
  handles_.clear();
}

std::vector<Corrector::Change> Corrector::changes(const Held& held) const {
  std::vector<Change> changed;
  const Held& base = system_.base();
  for (Index node = 0; node < static_cast<Index>(held.frame_of.size()); ++node) {
    const NodeFrame *before = base.find(node), *now = held.find(node);
    if (!before && !now) continue;
    if (!same_equalities(before, now))
      changed.push_back({node, false});
    else if (std::abs(drag_of(base, node) - drag_of(held, node)) > same_drag * drag_of(held, node))
      changed.push_back({node, true});
  }
  return changed;
}

/// Answers of the base to the residual and to each driven tool, with those of new handles behind them.
Eigen::MatrixXd Corrector::base_columns(const Problem& problem, const CellMatrices& cells, const Eigen::VectorXd& residual,
                                        const Iterate& from, const std::vector<Change>& changed,
                                        const std::vector<std::pair<Index, int>>& wanted) {
  const auto& mesh = *problem.mesh;
  const Held& base = system_.base();
  const Index driven = from.driven.size(), first = 1 + driven;
  std::vector<bool> let_go(mesh.nodes.size(), false), other_drag(mesh.nodes.size(), false);
  for (const auto& change : changed) (change.drag_only ? other_drag : let_go)[change.node] = true;
  Eigen::MatrixXd given = Eigen::MatrixXd::Zero(system_.size(), first + Index(wanted.size())), force = given;
  force.col(0) = residual;
  for (const auto& frame : base.frames) {
    if (let_go[frame.node]) continue;
    auto rows = given.block<dim, Eigen::Dynamic>(dim * frame.node, 0, dim, first);
    for (int a = 0; a < dim; ++a) {
      if (!frame.fixed[a]) continue;
      Eigen::RowVectorXd value = frame.given.row(a);
      value[0] += value.tail(driven).dot(from.driven) - frame.frame.col(a).dot(at(from.x, frame.node));
      rows += frame.frame.col(a) * value;
    }
    if (frame.friction_tool < 0 || other_drag[frame.node]) continue;
    const auto tools = driven_tools(problem);
    const Point along = frame.frame.col(dim - 1);
    for (Index k = 0; k < driven; ++k)
      if (tools[k] == frame.friction_tool)
        force.block<dim, 1>(dim * frame.node, 1 + k) +=
            base.drag[frame.node] * along.dot(core::axis_direction()) * along;
  }
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Handle& handle = handles_.at(wanted[i]);
    (handle.fixed ? given : force).block<dim, 1>(dim * handle.node, first + Index(i)) = handle.direction;
  }
  force -= product(mesh, cells, given, &held_cells_);
  return system_.solve(std::move(force)) + given;
}

void Corrector::add_handles(const Problem& problem, const CellMatrices& cells,
                            const std::vector<std::pair<Index, int>>& wanted) {
  const Held& base = system_.base();
  for (const auto& [node, axis] : wanted) {
    const NodeFrame* before = base.find(node);
    Handle handle{node, axis, fixes(before, axis), frame_of(before).col(axis), {}, {}};
    if (handle.fixed) {
      Eigen::VectorXd unit = Eigen::VectorXd::Zero(system_.size());
      unit.segment<dim>(dim * node) = handle.direction;
      const auto around = cells_with(*problem.mesh, [node = node](Index n) { return n == node; });
      const Eigen::VectorXd force = product(*problem.mesh, cells, unit, &around);
      for (Index i = 0; i < force.size(); ++i)
        if (force[i] != 0) handle.stiffness.push_back({i, force[i]});
    }
    handles_.emplace(std::pair(node, axis), std::move(handle));
  }
}

/// Adds to the base's answers what the changed nodes do.
bool Corrector::add_changes(const Problem& problem, const Held& held, const Eigen::VectorXd& residual, const Iterate& from,
                            const std::vector<Change>& changed, Eigen::MatrixXd& columns) const {
  const Held& base = system_.base();
  std::vector<const Handle*> handles;
  for (const auto& change : changed)
    for (int a = change.drag_only ? dim - 1 : 0; a < dim; ++a) handles.push_back(&handles_.at({change.node, a}));
  const Index count = static_cast<Index>(handles.size()), known = columns.cols();
  const auto tools = driven_tools(problem);
  // Along a row: what the unknowns (forces at free, velocities at fixed coordinates) do, then the known columns.
  const auto velocity = [&](Index node, const Point& along) {
    Eigen::RowVectorXd row(count + known);
    for (Index h = 0; h < count; ++h) row[h] = along.dot(at(handles[h]->response, node));
    for (Index c = 0; c < known; ++c) row[count + c] = along.dot(at(columns, node, c));
    return row;
  };
  const auto force = [&](Index h) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count + known);
    if (!handles[h]->fixed) {
      row[h] = 1;
      return row;
    }
    for (const auto& [unknown, value] : handles[h]->stiffness) {
      for (Index g = 0; g < count; ++g) row[g] += value * handles[g]->response[unknown];
      row.tail(known) += value * columns.row(unknown);
    }
    row[count] -= handles[h]->direction.dot(at(residual, handles[h]->node));
    return row;
  };
  Eigen::MatrixXd conditions(count, count + known);
  Index filled = 0, first = 0;
  for (const auto& change : changed) {
    const NodeFrame *before = base.find(change.node), *now = held.find(change.node);
    const core::Tensor frame = frame_of(now);
    const Point dragged = frame_of(before).col(dim - 1);
    const int from_axis = change.drag_only ? dim - 1 : 0;
    for (int a = from_axis; a < dim; ++a) {
      const Point along = frame.col(a);
      auto row = conditions.row(filled++);
      if (fixes(now, a)) {
        row = velocity(change.node, along);
        Eigen::RowVectorXd value = now->given.row(a);
        value[0] += value.tail(known - 1).dot(from.driven) - along.dot(at(from.x, change.node));
        row.tail(known) -= value;
        continue;
      }
      row.setZero();
      for (int b = from_axis; b < dim; ++b) {
        const Handle& handle = *handles[first + b - from_axis];
        row += along.dot(handle.direction) * force(first + b - from_axis);
      }
      if (const double drag = drag_of(base, change.node); drag > 0 && before)
        row -= drag * along.dot(dragged) * velocity(change.node, dragged);
      if (const double drag = drag_of(held, change.node); drag > 0 && a == dim - 1) {
        row += drag * velocity(change.node, along);
        for (Index k = 0; k + 1 < known; ++k)
          if (tools[k] == now->friction_tool) row[count + 1 + k] -= drag * along.dot(core::axis_direction());
      }
    }
    first += dim - from_axis;
  }
  const Eigen::MatrixXd unknowns = conditions.leftCols(count).partialPivLu().solve(-conditions.rightCols(known));
  if (!unknowns.allFinite()) return false;
  for (Index h = 0; h < count; ++h) columns += handles[h]->response * unknowns.row(h);
  return true;
}

std::optional<Eigen::MatrixXd> Corrector::correct(const Problem& problem, const CellMatrices& cells, const Held& held,
                                                  const Eigen::VectorXd& load, const Iterate& from) {
  const auto& mesh = *problem.mesh;
  const Eigen::VectorXd residual = unbalanced(problem, held, load, from);
  std::vector<Change> changed;
  std::vector<std::pair<Index, int>> wanted;
  std::size_t needed = 0;
  if (system_.factorised()) {
    changed = changes(held);
    for (const auto& change : changed)
      for (int a = change.drag_only ? dim - 1 : 0; a < dim; ++a, ++needed)
        if (!handles_.count({change.node, a})) wanted.push_back({change.node, a});
  }
  if (!system_.factorised() || needed > most_handles) {
    forget();
    changed.clear();
    wanted.clear();
    ++factorisations;
    if (!system_.factorise(mesh, cells, held)) return std::nullopt;
    held_cells_.clear();
  }
  if (held_cells_.empty() || !wanted.empty()) {
    std::vector<bool> touched(mesh.nodes.size(), false);
    for (const auto& frame : system_.base().frames) touched[frame.node] = true;
    for (const auto& [node, axis] : wanted) touched[node] = true;
    held_cells_ = cells_with(mesh, [&](Index n) { return touched[n]; });
  }
  add_handles(problem, cells, wanted);
  Eigen::MatrixXd columns = base_columns(problem, cells, residual, from, changed, wanted);
  const Index known = 1 + from.driven.size();
  for (std::size_t i = 0; i < wanted.size(); ++i) handles_.at(wanted[i]).response = columns.col(known + Index(i));
  columns.conservativeResize(Eigen::NoChange, known);
  if (!changed.empty() && !add_changes(problem, held, residual, from, changed, columns)) return std::nullopt;
  return columns;
}

}  // namespace parison::flow
