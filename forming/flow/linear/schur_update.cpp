// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/linear/schur_update.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parison::flow {

using core::dim;

namespace {

/// A drag that changed by less, relatively, is the same.
constexpr double same_drag = 1e-9;

core::Tensor frame_of(const NodeFrame* held) {
  return held ? held->frame : core::Tensor(core::Tensor::Identity());
}

bool fixes(const NodeFrame* held, int axis) {
  return held && held->fixed[axis];
}

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

/// Whether a tool holds the node's normal velocity and nothing else.
bool slides(const NodeFrame& held) {
  return fixes(&held, 0) && !fixes(&held, 1) && held.friction_tool < 0;
}

/// Whether one coordinate tells all that changed at a node.
bool only_normal(const NodeFrame* before, const NodeFrame* now, const Handles& handles) {
  if (before) return !now && slides(*before);
  if (!slides(*now)) return false;
  const auto known = handles.find({now->node, 0});
  return known == handles.end() || known->second.direction == now->frame.col(0);
}

/// What the unknowns of the dense system (forces at free, velocities at fixed coordinates) and the known columns do, as
/// rows of coefficients: first the unknowns', then the columns'.
struct Effects {
  const Rearrangement& what;
  const Eigen::MatrixXd& columns;
  std::vector<const Handle*> handles;

  Index count() const { return static_cast<Index>(handles.size()); }
  Index known() const { return columns.cols(); }

  Eigen::RowVectorXd velocity(Index node, const Point& along) const {
    Eigen::RowVectorXd row(count() + known());
    for (Index h = 0; h < count(); ++h) row[h] = along.dot(node_velocity(handles[h]->response, node));
    row.tail(known()) = along.transpose() * columns.middleRows<dim>(dim * node);
    return row;
  }

  Eigen::RowVectorXd force(Index h) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count() + known());
    if (!handles[h]->fixed) {
      row[h] = 1;
      return row;
    }
    for (const auto& [unknown, value] : handles[h]->stiffness) {
      for (Index g = 0; g < count(); ++g) row[g] += value * handles[g]->response[unknown];
      row.tail(known()) += value * columns.row(unknown);
    }
    row[count()] -= handles[h]->direction.dot(node_velocity(what.residual, handles[h]->node));
    return row;
  }

  /// The velocity along a coordinate that is fixed now: zero when it is the given one.
  Eigen::RowVectorXd fixed(const NodeFrame& now, int axis) const {
    const Point along = now.frame.col(axis);
    Eigen::RowVectorXd row = velocity(now.node, along), value = now.given.row(axis);
    value[0] += value.tail(known() - 1).dot(what.from.driven) - along.dot(node_velocity(what.from.x, now.node));
    row.tail(known()) -= value;
    return row;
  }

  /// The force along a coordinate that is free now: zero in balance. `first` is the handle of the change's first axis.
  Eigen::RowVectorXd free(const Change& change, int axis, Index first) const {
    const NodeFrame *before = what.base.find(change.node), *now = what.held.find(change.node);
    const Point along =
        change.kind == Change::Kind::normal ? handles[first]->direction : Point(frame_of(now).col(axis));
    const Point dragged = frame_of(before).col(dim - 1);
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count() + known());
    const Index end = first + change.end_axis() - change.first_axis();
    for (Index h = first; h < end; ++h) row += along.dot(handles[h]->direction) * force(h);
    if (const double drag = drag_of(what.base, change.node); drag > 0)
      row -= drag * along.dot(dragged) * velocity(change.node, dragged);
    if (const double drag = drag_of(what.held, change.node); drag > 0 && axis == dim - 1) {
      const auto tools = driven_tools(what.problem);
      row += drag * velocity(change.node, along);
      for (Index k = 0; k + 1 < known(); ++k)
        if (tools[k] == now->friction_tool) row[count() + 1 + k] -= drag * along.dot(core::axis_direction());
    }
    return row;
  }
};

}  // namespace

std::vector<Change> changed_nodes(const Held& base, const Held& held, const Handles& handles) {
  std::vector<Change> changed;
  for (Index node = 0; node < static_cast<Index>(held.frame_of.size()); ++node) {
    const NodeFrame *before = base.find(node), *now = held.find(node);
    if (!before && !now) continue;
    if (!same_equalities(before, now))
      changed.push_back({only_normal(before, now, handles) ? Change::Kind::normal : Change::Kind::whole, node});
    else if (std::abs(drag_of(base, node) - drag_of(held, node)) > same_drag * drag_of(held, node))
      changed.push_back({Change::Kind::drag, node});
  }
  return changed;
}

Handle make_handle(const core::Mesh& mesh, const CellMatrices& cells, const Held& base, const Held& held,
                   const Handles& handles, std::pair<Index, int> coordinate) {
  const auto [node, axis] = coordinate;
  const NodeFrame* before = base.find(node);
  Handle handle{node, axis, fixes(before, axis), frame_of(before ? before : held.find(node)).col(axis), {}, {}};
  if (const auto beside = handles.find({node, 1 - axis}); !before && beside != handles.end())
    handle.direction = perpendicular(beside->second.direction);
  if (!handle.fixed) return handle;
  std::map<Index, double> force;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found == nodes.end()) continue;
    const auto where = unknowns_of(mesh, c);
    const auto part = (cells.of(c).middleCols<dim>(dim * (found - nodes.begin())) * handle.direction).eval();
    for (int k = 0; k < cell_unknowns; ++k) force[where[k]] += part[k];
  }
  handle.stiffness.assign(force.begin(), force.end());
  return handle;
}

bool add_changes(const Rearrangement& what, const std::vector<Change>& changed, const Handles& handles,
                 Eigen::MatrixXd& columns) {
  Effects effects{what, columns, {}};
  for (const auto& change : changed)
    for (int a = change.first_axis(); a < change.end_axis(); ++a)
      effects.handles.push_back(&handles.at({change.node, a}));
  const Index count = effects.count(), known = effects.known();
  Eigen::MatrixXd conditions(count, count + known);
  Index filled = 0;
  for (const auto& change : changed) {
    const Index first = filled;
    const NodeFrame* now = what.held.find(change.node);
    for (int a = change.first_axis(); a < change.end_axis(); ++a)
      conditions.row(filled++) = fixes(now, a) ? effects.fixed(*now, a) : effects.free(change, a, first);
  }
  const Eigen::MatrixXd unknowns = conditions.leftCols(count).partialPivLu().solve(-conditions.rightCols(known));
  if (!unknowns.allFinite()) return false;
  for (Index column = 0; column < known; ++column)
    for (Index h = 0; h < count; ++h) columns.col(column) += unknowns(h, column) * effects.handles[h]->response;
  return true;
}

using core::dim;

namespace {

/// More new back-substitutions than this cost more than a factorisation, with 2 k triangles as with 40 k.
constexpr std::size_t most_new_handles = 40;
/// Handles that are there cost the dense system alone.
constexpr std::size_t most_handles = 100;
/// Of a velocity: nearer to the given one than this is round-off.
constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();

/// The base's velocities that are given and the forces on it, a column for the residual and one for each driven tool.
struct Loading {
  Eigen::MatrixXd given, force;
};

/// At the nodes that are held as in the base; the changed ones have handles.
void load_held_nodes(const Rearrangement& what, const std::vector<Change>& changed, Loading& loading) {
  const Index driven = what.from.driven.size(), first = 1 + driven;
  std::vector<bool> let_go(what.held.frame_of.size(), false), other_drag = let_go;
  for (const auto& change : changed) (change.kind == Change::Kind::drag ? other_drag : let_go)[change.node] = true;
  const auto tools = driven_tools(what.problem);
  for (const auto& frame : what.base.frames) {
    if (let_go[frame.node]) continue;
    auto rows = loading.given.block<dim, Eigen::Dynamic>(dim * frame.node, 0, dim, first);
    for (int a = 0; a < dim; ++a) {
      if (!frame.fixed[a]) continue;
      Eigen::RowVectorXd value = what.held.find(frame.node)->given.row(a);
      const Point now = node_velocity(what.from.x, frame.node);
      value[0] += value.tail(driven).dot(what.from.driven) - frame.frame.col(a).dot(now);
      if (std::abs(value[0]) <= round_off * now.norm()) value[0] = 0;
      rows += frame.frame.col(a) * value;
    }
    if (frame.friction_tool < 0 || other_drag[frame.node]) continue;
    const Point along = frame.frame.col(dim - 1);
    for (Index k = 0; k < driven; ++k)
      if (tools[k] == frame.friction_tool)
        loading.force.block<dim, 1>(dim * frame.node, 1 + k) +=
            what.base.drag[frame.node] * along.dot(core::axis_direction()) * along;
  }
}

}  // namespace

void Corrector::start(Eigen::VectorXd beside) {
  beside_ = std::move(beside);
  factorisations = 0;
  forget();
}

void Corrector::forget() {
  system_.forget();
  handles_.clear();
  beside_answer_.resize(0);
}

bool Corrector::renew_base(const core::Mesh& mesh, const CellMatrices& cells, const Held& held) {
  forget();
  ++factorisations;
  if (!system_.factorise(mesh, cells, held)) return false;
  held_batches_ = held_batches(mesh, held);
  return true;
}

Eigen::MatrixXd Corrector::base_answers(const Rearrangement& what, const CellMatrices& cells,
                                        const std::vector<Change>& changed, const std::vector<Handle*>& wanted) const {
  const Index first = 1 + what.from.driven.size();
  const bool beside = beside_answer_.size() < beside_.size();
  const Index all = first + Index(wanted.size()) + beside;
  Loading loading{Eigen::MatrixXd::Zero(system_.size(), first), Eigen::MatrixXd::Zero(system_.size(), all)};
  load_held_nodes(what, changed, loading);
  loading.force.col(0) += what.residual;
  loading.force.leftCols(first) -= product(*what.problem.mesh, cells, loading.given, held_batches_);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    auto force = loading.force.col(first + Index(i));
    if (!wanted[i]->fixed) force.segment<dim>(dim * wanted[i]->node) = wanted[i]->direction;
    for (const auto& [unknown, value] : wanted[i]->stiffness) force[unknown] = -value;
  }
  if (beside) loading.force.col(all - 1) = beside_;
  Eigen::MatrixXd answers = system_.solve(std::move(loading.force));
  answers.leftCols(first) += loading.given;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]->fixed) answers.block<dim, 1>(dim * wanted[i]->node, first + Index(i)) += wanted[i]->direction;
  return answers;
}

std::optional<Eigen::MatrixXd> Corrector::correct(const Problem& problem, const CellMatrices& cells, const Held& held,
                                                  const Eigen::VectorXd& load, const Iterate& from) {
  const auto& mesh = *problem.mesh;
  std::vector<Change> changed;
  std::vector<std::pair<Index, int>> unknown;  // coordinates of changed nodes without a handle
  std::size_t needed = 0;
  if (system_.factorised()) {
    changed = changed_nodes(system_.base(), held, handles_);
    for (const auto& change : changed)
      for (int a = change.first_axis(); a < change.end_axis(); ++a, ++needed)
        if (!handles_.count({change.node, a})) unknown.push_back({change.node, a});
  }
  if (!system_.factorised() || unknown.size() > most_new_handles || needed > most_handles) {
    changed.clear();
    unknown.clear();
    if (!renew_base(mesh, cells, held)) return std::nullopt;
  }
  std::vector<Handle*> wanted;
  for (const auto& coordinate : unknown) {
    auto handle = make_handle(mesh, cells, system_.base(), held, handles_, coordinate);
    wanted.push_back(&handles_.emplace(coordinate, std::move(handle)).first->second);
  }
  const Eigen::VectorXd residual = unbalanced(problem, held, load, from);
  const Rearrangement what{problem, system_.base(), held, residual, from};
  Eigen::MatrixXd columns = base_answers(what, cells, changed, wanted);
  const Index known = 1 + from.driven.size();
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i]->response = columns.col(known + Index(i));
  if (const Index last = known + Index(wanted.size()); columns.cols() > last) beside_answer_ = columns.col(last);
  columns.conservativeResize(Eigen::NoChange, known);
  if (!changed.empty() && !add_changes(what, changed, handles_, columns)) return std::nullopt;
  return columns;
}

std::optional<Eigen::VectorXd> Corrector::answer_beside(const Problem& problem, const Held& held) const {
  const auto changed = changed_nodes(system_.base(), held, handles_);
  if (changed.empty()) return beside_answer_;
  Held at_rest = held;
  for (auto& frame : at_rest.frames) frame.given.setZero();
  const Index driven = Index(driven_tools(problem).size());
  const Iterate rest{Eigen::VectorXd::Zero(system_.size()), {}, Eigen::VectorXd::Zero(driven)};
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(system_.size(), 1 + driven);  // those of the tools are not asked for
  columns.col(0) = beside_answer_;
  if (!add_changes({problem, system_.base(), at_rest, beside_, rest}, changed, handles_, columns)) return std::nullopt;
  return columns.col(0);
}

}  // namespace parison::flow
