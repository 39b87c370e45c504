// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parison::flow {

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
