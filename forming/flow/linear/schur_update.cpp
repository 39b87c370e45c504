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

/// Relative change of a tangential stiffness that is ignored.
constexpr double same_stiffness = 1e-9;

core::Tensor basis_of(const NodeConstraint* constraint) {
  return constraint ? constraint->basis : core::Tensor(core::Tensor::Identity());
}

bool fixes(const NodeConstraint* constraint, int axis) {
  return constraint && constraint->fixed[axis];
}

/// Tangential stiffness of friction along the last column of the local basis, N.s/m.
double tangential_stiffness_of(const Constraints& constraints, Index node) {
  const NodeConstraint* constraint = constraints.find(node);
  return constraint && constraint->friction_tool >= 0 ? constraints.tangential_stiffness[node] : 0.0;
}

bool same_equalities(const NodeConstraint* a, const NodeConstraint* b) {
  if (!a || !b) return a == b;
  if (a->friction_tool != b->friction_tool || a->equalities.size() != b->equalities.size()) return false;
  for (std::size_t i = 0; i < a->equalities.size(); ++i)
    if (a->equalities[i].candidate != b->equalities[i].candidate || a->equalities[i].normal != b->equalities[i].normal)
      return false;
  return true;
}

/// Whether the normal velocity is fixed and nothing else, without friction.
bool slides(const NodeConstraint& constraint) {
  return fixes(&constraint, 0) && !fixes(&constraint, 1) && constraint.friction_tool < 0;
}

/// Whether the normal coordinate alone describes the change at a node.
bool only_normal(const NodeConstraint* before, const NodeConstraint* now, const SchurColumns& schur_columns) {
  if (before) return !now && slides(*before);
  if (!slides(*now)) return false;
  const auto known = schur_columns.find({now->node, 0});
  return known == schur_columns.end() || known->second.direction == now->basis.col(0);
}

/// The dense system for the changed coordinates. Its unknowns are forces at coordinates that the base leaves free and
/// velocities at those that it fixes. Rows of coefficients: first those of the unknowns, then those of the known
/// columns.
struct DenseSystem {
  const ConstraintChange& update;
  const Eigen::MatrixXd& columns;
  std::vector<const SchurColumn*> schur_columns;

  Index count() const { return static_cast<Index>(schur_columns.size()); }
  Index known() const { return static_cast<Index>(columns.cols()); }

  /// Velocity of a node along a direction.
  Eigen::RowVectorXd velocity(Index node, const Point& along) const {
    Eigen::RowVectorXd row(count() + known());
    for (Index h = 0; h < count(); ++h) row[h] = along.dot(node_velocity(schur_columns[h]->response, node));
    row.tail(known()) = along.transpose() * columns.middleRows<dim>(dim * node);
    return row;
  }

  /// External force at the coordinate of column h.
  Eigen::RowVectorXd force(Index h) const {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count() + known());
    if (!schur_columns[h]->fixed) {
      row[h] = 1;
      return row;
    }
    for (const auto& [unknown, value] : schur_columns[h]->stiffness) {
      for (Index g = 0; g < count(); ++g) row[g] += value * schur_columns[g]->response[unknown];
      row.tail(known()) += value * columns.row(unknown);
    }
    row[count()] -= schur_columns[h]->direction.dot(node_velocity(update.residual, schur_columns[h]->node));
    return row;
  }

  /// Velocity along a coordinate that is fixed now minus the prescribed one, to be zero.
  Eigen::RowVectorXd fixed(const NodeConstraint& now, int axis) const {
    const Point along = now.basis.col(axis);
    Eigen::RowVectorXd row = velocity(now.node, along), value = now.given.row(axis);
    value[0] += value.tail(known() - 1).dot(update.from.driven) - along.dot(node_velocity(update.from.x, now.node));
    row.tail(known()) -= value;
    return row;
  }

  /// Force along a coordinate that is free now, to be zero, friction included. `first` is the column of the change's
  /// first axis.
  Eigen::RowVectorXd free(const NodeChange& change, int axis, Index first) const {
    const NodeConstraint *before = update.base.find(change.node), *now = update.constraints.find(change.node);
    const Point along =
        change.kind == NodeChange::Kind::normal ? schur_columns[first]->direction : Point(basis_of(now).col(axis));
    const Point friction_direction = basis_of(before).col(dim - 1);
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(count() + known());
    const Index end = first + change.end_axis() - change.first_axis();
    for (Index h = first; h < end; ++h) row += along.dot(schur_columns[h]->direction) * force(h);
    if (const double stiffness = tangential_stiffness_of(update.base, change.node); stiffness > 0)
      row -= stiffness * along.dot(friction_direction) * velocity(change.node, friction_direction);
    if (const double stiffness = tangential_stiffness_of(update.constraints, change.node);
        stiffness > 0 && axis == dim - 1) {
      const auto tools = driven_tools(update.problem);
      row += stiffness * velocity(change.node, along);
      for (Index k = 0; k + 1 < known(); ++k)
        if (tools[k] == now->friction_tool) row[count() + 1 + k] -= stiffness * along.dot(core::axis_direction());
    }
    return row;
  }
};

}  // namespace

std::vector<NodeChange> changed_nodes(const Constraints& base, const Constraints& constraints,
                                      const SchurColumns& schur_columns) {
  std::vector<NodeChange> changed;
  for (Index node = 0; node < static_cast<Index>(constraints.index_of.size()); ++node) {
    const NodeConstraint *before = base.find(node), *now = constraints.find(node);
    if (!before && !now) continue;
    if (!same_equalities(before, now))
      changed.push_back(
          {only_normal(before, now, schur_columns) ? NodeChange::Kind::normal : NodeChange::Kind::whole, node});
    else if (std::abs(tangential_stiffness_of(base, node) - tangential_stiffness_of(constraints, node)) >
             same_stiffness * std::abs(tangential_stiffness_of(constraints, node)))
      changed.push_back({NodeChange::Kind::friction, node});
  }
  return changed;
}

SchurColumn make_schur_column(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base,
                              const Constraints& constraints, const SchurColumns& schur_columns,
                              std::pair<Index, int> coordinate) {
  const auto [node, axis] = coordinate;
  const NodeConstraint* before = base.find(node);
  SchurColumn column{node, axis, fixes(before, axis), basis_of(before ? before : constraints.find(node)).col(axis),
                     {},   {}};
  if (const auto other = schur_columns.find({node, 1 - axis}); !before && other != schur_columns.end())
    column.direction = perpendicular(other->second.direction);
  if (!column.fixed) return column;
  std::map<Index, double> force;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells()[c];
    const auto found = std::find(nodes.begin(), nodes.end(), node);
    if (found == nodes.end()) continue;
    const auto where = unknowns_of(mesh, c);
    const auto part = (cells.of(c).middleCols<dim>(dim * (found - nodes.begin())) * column.direction).eval();
    for (int k = 0; k < cell_unknowns; ++k) force[where[k]] += part[k];
  }
  column.stiffness.assign(force.begin(), force.end());
  return column;
}

bool add_schur_correction(const ConstraintChange& update, const std::vector<NodeChange>& changed,
                          const SchurColumns& schur_columns, Eigen::MatrixXd& columns) {
  DenseSystem dense{update, columns, {}};
  for (const auto& change : changed)
    for (int a = change.first_axis(); a < change.end_axis(); ++a)
      dense.schur_columns.push_back(&schur_columns.at({change.node, a}));
  const Index count = dense.count(), known = dense.known();
  Eigen::MatrixXd conditions(count, count + known);
  Index filled = 0;
  for (const auto& change : changed) {
    const Index first = filled;
    const NodeConstraint* now = update.constraints.find(change.node);
    for (int a = change.first_axis(); a < change.end_axis(); ++a)
      conditions.row(filled++) = fixes(now, a) ? dense.fixed(*now, a) : dense.free(change, a, first);
  }
  const Eigen::MatrixXd unknowns = conditions.leftCols(count).partialPivLu().solve(-conditions.rightCols(known));
  if (!unknowns.allFinite()) return false;
  for (Index column = 0; column < known; ++column)
    for (Index h = 0; h < count; ++h) columns.col(column) += unknowns(h, column) * dense.schur_columns[h]->response;
  return true;
}

namespace {

/// More back-substitutions than this cost more than a factorisation, with 2000 triangles as with 40000 (measured).
constexpr std::size_t max_new_schur_columns = 40;
/// Columns that are known cost the dense system alone.
constexpr std::size_t max_schur_columns = 100;
/// Difference from the prescribed velocity, relative to the node's, that counts as round-off.
constexpr double round_off = 4 * std::numeric_limits<double>::epsilon();

/// Prescribed velocities and forces of the base, a column for the residual and one for each m/s of each driven tool.
struct Loading {
  Eigen::MatrixXd given, force;
};

/// Sets the loading at the nodes whose constraints are those of the base; the changed nodes have Schur columns.
void load_constrained_nodes(const ConstraintChange& update, const std::vector<NodeChange>& changed, Loading& loading) {
  const Index driven = Index(update.from.driven.size()), first = 1 + driven;
  std::vector<bool> constraint_changed(update.constraints.index_of.size(), false),
      friction_changed = constraint_changed;
  for (const auto& change : changed)
    (change.kind == NodeChange::Kind::friction ? friction_changed : constraint_changed)[change.node] = true;
  const auto tools = driven_tools(update.problem);
  for (const auto& constraint : update.base.nodes) {
    if (constraint_changed[constraint.node]) continue;
    auto rows = loading.given.block<dim, Eigen::Dynamic>(dim * constraint.node, 0, dim, first);
    for (int a = 0; a < dim; ++a) {
      if (!constraint.fixed[a]) continue;
      Eigen::RowVectorXd value = update.constraints.find(constraint.node)->given.row(a);
      const Point now = node_velocity(update.from.x, constraint.node);
      value[0] += value.tail(driven).dot(update.from.driven) - constraint.basis.col(a).dot(now);
      if (std::abs(value[0]) <= round_off * now.norm()) value[0] = 0;
      rows += constraint.basis.col(a) * value;
    }
    if (constraint.friction_tool < 0 || friction_changed[constraint.node]) continue;
    const Point along = constraint.basis.col(dim - 1);
    for (Index k = 0; k < driven; ++k)
      if (tools[k] == constraint.friction_tool)
        loading.force.block<dim, 1>(dim * constraint.node, 1 + k) +=
            update.base.tangential_stiffness[constraint.node] * along.dot(core::axis_direction()) * along;
  }
}

}  // namespace

void Corrector::start(Eigen::VectorXd additional_rhs) {
  additional_rhs_ = std::move(additional_rhs);
  factorisations = 0;
  forget();
}

void Corrector::forget() {
  system_.forget();
  schur_columns_.clear();
  additional_solution_.resize(0);
}

bool Corrector::refactorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& constraints) {
  forget();
  ++factorisations;
  if (!system_.factorise(mesh, cells, constraints)) return false;
  constrained_batches_ = constrained_batches(mesh, constraints);
  return true;
}

Eigen::MatrixXd Corrector::base_solutions(const ConstraintChange& update, const CellMatrices& cells,
                                          const std::vector<NodeChange>& changed,
                                          const std::vector<SchurColumn*>& wanted) const {
  const Index first = 1 + Index(update.from.driven.size());
  const bool with_additional = additional_solution_.size() < additional_rhs_.size();
  const Index all = first + Index(wanted.size()) + with_additional;
  Loading loading{Eigen::MatrixXd::Zero(system_.size(), first), Eigen::MatrixXd::Zero(system_.size(), all)};
  load_constrained_nodes(update, changed, loading);
  loading.force.col(0) += update.residual;
  loading.force.leftCols(first) -= product(*update.problem.mesh, cells, loading.given, constrained_batches_);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    auto force = loading.force.col(first + Index(i));
    if (!wanted[i]->fixed) force.segment<dim>(dim * wanted[i]->node) = wanted[i]->direction;
    for (const auto& [unknown, value] : wanted[i]->stiffness) force[unknown] = -value;
  }
  if (with_additional) loading.force.col(all - 1) = additional_rhs_;
  Eigen::MatrixXd solution = system_.solve(std::move(loading.force));
  solution.leftCols(first) += loading.given;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i]->fixed) solution.block<dim, 1>(dim * wanted[i]->node, first + Index(i)) += wanted[i]->direction;
  return solution;
}

bool Corrector::select_columns(const Constraints& constraints, std::vector<NodeChange>& changed,
                               std::vector<std::pair<Index, int>>& missing) const {
  if (!system_.factorised()) return false;
  auto found = changed_nodes(system_.base(), constraints, schur_columns_);
  std::vector<std::pair<Index, int>> without_column;
  std::size_t needed = 0;
  for (const auto& change : found)
    for (int a = change.first_axis(); a < change.end_axis(); ++a, ++needed)
      if (!schur_columns_.count({change.node, a})) without_column.push_back({change.node, a});
  if (without_column.size() > max_new_schur_columns || needed > max_schur_columns) return false;
  changed = std::move(found);
  missing = std::move(without_column);
  return true;
}

std::optional<Eigen::MatrixXd> Corrector::correct(const Problem& problem, const CellMatrices& cells,
                                                  const Constraints& constraints, const Eigen::VectorXd& load,
                                                  const Iterate& from) {
  const auto& mesh = *problem.mesh;
  std::vector<NodeChange> changed;
  std::vector<std::pair<Index, int>> missing;
  if (!select_columns(constraints, changed, missing) && !refactorise(mesh, cells, constraints)) return std::nullopt;
  std::vector<SchurColumn*> wanted;
  for (const auto& coordinate : missing) {
    auto schur_column = make_schur_column(mesh, cells, system_.base(), constraints, schur_columns_, coordinate);
    wanted.push_back(&schur_columns_.emplace(coordinate, std::move(schur_column)).first->second);
  }
  const Eigen::VectorXd residual = flow::residual(problem, constraints, load, from);
  const ConstraintChange update{problem, system_.base(), constraints, residual, from};
  Eigen::MatrixXd columns = base_solutions(update, cells, changed, wanted);
  const Index known = 1 + Index(from.driven.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i]->response = columns.col(known + Index(i));
  if (const Index last = known + Index(wanted.size()); columns.cols() > last) additional_solution_ = columns.col(last);
  columns.conservativeResize(Eigen::NoChange, known);
  if (!changed.empty() && !add_schur_correction(update, changed, schur_columns_, columns)) return std::nullopt;
  return columns;
}

std::optional<Eigen::VectorXd> Corrector::additional_solution(const Problem& problem,
                                                              const Constraints& constraints) const {
  return at_rest(problem, constraints, additional_rhs_, additional_solution_);
}

std::optional<Eigen::VectorXd> Corrector::response_to(const Problem& problem, const Constraints& constraints,
                                                      const Eigen::VectorXd& force) const {
  return at_rest(problem, constraints, force, system_.solve(force));
}

std::optional<Eigen::VectorXd> Corrector::at_rest(const Problem& problem, const Constraints& constraints,
                                                  const Eigen::VectorXd& rhs,
                                                  const Eigen::VectorXd& base_solution) const {
  const auto changed = changed_nodes(system_.base(), constraints, schur_columns_);
  if (changed.empty()) return base_solution;
  Constraints resting = constraints;
  for (auto& constraint : resting.nodes) constraint.given.setZero();
  const Index driven = Index(driven_tools(problem).size());
  const Iterate rest{Eigen::VectorXd::Zero(system_.size()), {}, Eigen::VectorXd::Zero(driven), {}};
  Eigen::MatrixXd columns =
      Eigen::MatrixXd::Zero(system_.size(), 1 + driven);  // the columns of the tools are not needed
  columns.col(0) = base_solution;
  if (!add_schur_correction({problem, system_.base(), resting, rhs, rest}, changed, schur_columns_, columns))
    return std::nullopt;
  return columns.col(0);
}

}  // namespace parison::flow
