// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::flow {

using core::dim;

namespace {

/// Resistance added to every driven tool, as shares of its own. Tools that only press glass against each other would
/// drift together without it; they are told by a resistance against a common motion below the third share of the
/// largest, and get more, as round-off would move them otherwise.
constexpr double min_resistance = 1e-12, drift_resistance = 1e-10, unresisted = 1e-8;

/// Force balance of the driven tools, some of which move at their speed limit.
struct ToolBalance {
  const Problem& problem;
  const std::vector<Index>& driven;
  const Eigen::MatrixXd& force;  ///< axial force, N: column 0 at rest, column 1 + k per m/s of driven tool k
  Eigen::VectorXd velocity;      ///< m/s
  std::vector<bool> limited;     ///< at the speed limit
  const AirResponse* air;        ///< null without trapped air
  Eigen::VectorXd pressure;      ///< of its pockets, gauge, Pa

  Index count() const { return static_cast<Index>(driven.size()); }
  double speed_limit(Index k) const { return problem.tools[driven[k]].speed_limit; }
  void limit(Index k, double direction) {
    velocity[k] = std::copysign(speed_limit(k), direction);
    limited[k] = true;
  }

  /// Velocities at which the tools below their limit are in balance. Tools that nothing resists go to their limit, or
  /// stay where nothing drives them either.
  void solve() {
    Eigen::MatrixXd resistance = Eigen::MatrixXd::Identity(count(), count());
    Eigen::VectorXd rhs = velocity;
    for (Index k = 0; k < count(); ++k) {
      if (limited[k]) continue;
      resistance.row(k) = force.block(k, 1, 1, count());
      rhs[k] = *problem.tools[driven[k]].force - force(k, 0);
    }
    for (Index k = 0; k < count(); ++k)
      if (!limited[k] && resistance(k, k) <= 0 && !meets_air(k)) {
        if (rhs[k] != 0) limit(k, rhs[k]);
        resistance.row(k) = Eigen::RowVectorXd::Unit(count(), k);
        rhs[k] = rhs[k] != 0 ? velocity[k] : 0;
      }
    const Eigen::VectorXd added = added_resistance(resistance);
    resistance.diagonal() += added;
    solve(resistance, rhs);
    // Glass that tools enclose resists them by what its incompressibility is enforced with, and little of that is much.
    solve(resistance, rhs + added.cwiseProduct(velocity));
  }

  Eigen::VectorXd added_resistance(const Eigen::MatrixXd& resistance) const {
    Eigen::VectorXd added = Eigen::VectorXd::Zero(count());
    if (count() == 0) return added;
    const double largest = resistance.diagonal().maxCoeff();
    double together = 0;  // N per m/s
    for (Index k = 0; k < count(); ++k)
      if (!limited[k]) together = std::max(together, std::abs(resistance.row(k).sum()));
    const double share = together < unresisted * largest ? drift_resistance : min_resistance;
    for (Index k = 0; k < count(); ++k)
      if (!limited[k]) added[k] = share * resistance(k, k);
    return added;
  }

  void solve(const Eigen::MatrixXd& resistance, const Eigen::VectorXd& rhs) {
    if (air)
      solve_with_air(resistance, rhs);
    else
      velocity = resistance.partialPivLu().solve(rhs);
  }

  bool meets_air(Index k) const { return air && (air->rate.col(1 + k).array() != 0).any(); }

  void solve_with_air(const Eigen::MatrixXd& resistance, const Eigen::VectorXd& rhs) {
    const Index pockets = air->pockets();
    AirBalance balance{*air, Eigen::MatrixXd::Zero(count(), count() + pockets), rhs};
    balance.resistance.leftCols(count()) = resistance;
    for (Index k = 0; k < count(); ++k)
      if (!limited[k]) balance.resistance.row(k).tail(pockets) = force.row(k).tail(pockets);
    Eigen::VectorXd unknowns(count() + pockets);
    unknowns << velocity, pressure;
    unknowns = balance.solve(std::move(unknowns));
    velocity = unknowns.head(count());
    pressure = unknowns.tail(pockets);
  }

  /// The tool that exceeds its speed limit by the largest factor; -1 where none does.
  Index fastest_beyond_limit() const {
    Index fastest = -1;
    double most = 1;
    for (Index k = 0; k < count(); ++k)
      if (const double fraction = std::abs(velocity[k]) / speed_limit(k); !limited[k] && fraction > most) {
        most = fraction;
        fastest = k;
      }
    return fastest;
  }
};

/// Velocities of the driven tools, m/s: in force balance, or at the speed limit where balance would exceed it; with the
/// pressures of trapped air.
ToolBalance balanced_tools(const Problem& problem, const std::vector<Index>& driven, const Eigen::MatrixXd& force,
                           const AirResponse* air, const Eigen::VectorXd& first_guess) {
  const auto count = static_cast<Index>(driven.size());
  ToolBalance balance{problem, driven,     force, Eigen::VectorXd::Zero(count), std::vector<bool>(count, false),
                      air,     first_guess};
  for (Index round = 0; (count > 0 || air) && round <= count; ++round) {
    balance.solve();
    const Index fastest = balance.fastest_beyond_limit();
    if (fastest < 0) break;
    balance.limit(fastest, balance.velocity[fastest]);
  }
  return balance;
}

/// Adds the forces of the tools on trapped air, N, to those on the glass; columns as in ToolSuperposition.
void add_air_forces(const TrappedAir& air, const AirLoads& loads, const std::vector<Index>& driven,
                    Eigen::MatrixXd& force) {
  const Index first = 1 + static_cast<Index>(driven.size());
  for (std::size_t k = 0; k < driven.size(); ++k) {
    force(Index(k), 0) += loads.tool_force[driven[k]];
    for (std::size_t j = 0; j < air.pockets.size(); ++j)
      force(Index(k), first + Index(j)) -= air.pockets[j].tool_area[driven[k]];
  }
}

/// Adds the response to the pressures of trapped air, Pa, whose columns and forces come last.
void add_pressures(const Eigen::VectorXd& pressure, const ToolSuperposition& columns,
                   const std::vector<ContactForces>& forces, Response& response) {
  const Index first = static_cast<Index>(forces.size()) - static_cast<Index>(pressure.size());
  for (Index j = 0; j < pressure.size(); ++j) {
    response.unknowns += pressure[j] * columns.unknowns.col(first + j);
    response.forces.add(pressure[j], forces[first + j]);
  }
}

}  // namespace

ToolSuperposition superpose(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                            const Eigen::VectorXd& load, Eigen::MatrixXd correction, const Iterate& iterate,
                            const AirLoads* air) {
  const core::Mesh& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count(), driven = Index(iterate.driven.size());
  ToolSuperposition columns{std::move(correction), {}};
  columns.reaction = product(mesh, cells, columns.unknowns, constrained_batches(mesh, constraints)).topRows(velocities);
  columns.reaction.col(0) += iterate.force.head(velocities) - load.head(velocities);
  columns.reaction.col(0) -= columns.reaction.middleCols(1, driven) * iterate.driven;
  columns.unknowns.col(0) += iterate.x - columns.unknowns.middleCols(1, driven) * iterate.driven;
  if (!air) return columns;
  const Index pockets = Index(air->unit.cols());
  columns.reaction.rightCols(pockets) -= air->unit;
  columns.reaction.col(0) -= columns.reaction.rightCols(pockets) * iterate.air_pressure;
  columns.unknowns.col(0) -= columns.unknowns.rightCols(pockets) * iterate.air_pressure;
  return columns;
}

Response balance_tools(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                       const ToolSuperposition& columns, const AirLoads* air, const Eigen::VectorXd& first_guess) {
  const auto driven = driven_tools(problem);
  const Index count = Index(columns.unknowns.cols());
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(Index(driven.size()), count);
  std::vector<ContactForces> parts;
  for (Index column = 0; column < count; ++column) {
    parts.push_back(contact_forces(problem, constraints, columns.reaction.col(column)));
    for (std::size_t i = 0; i < problem.candidates.size(); ++i)
      for (std::size_t k = 0; k < driven.size(); ++k)
        if (problem.candidates[i].tool == driven[k]) force(k, column) += parts.back().axial[i];
  }
  AirResponse air_rates;
  if (air) {
    add_air_forces(*problem.air, *air, driven, force);
    air_rates = air_response(problem, *air, columns.unknowns, driven);
  }
  const auto balance = balanced_tools(problem, driven, force, air ? &air_rates : nullptr, first_guess);
  const Eigen::VectorXd& velocity = balance.velocity;
  Response response{columns.unknowns.col(0), parts[0], {}, balance.pressure};
  for (const auto& tool : problem.tools) response.tool_velocity.push_back(tool.velocity);
  for (std::size_t k = 0; k < driven.size(); ++k) {
    response.unknowns += velocity[k] * columns.unknowns.col(1 + k);
    response.forces.add(velocity[k], parts[1 + k]);
    response.tool_velocity[driven[k]] = velocity[k];
  }
  if (air) add_pressures(balance.pressure, columns, parts, response);
  return response;
}

std::vector<Index> constrained_batches(const core::Mesh& mesh, const Constraints& constraints) {
  std::vector<Index> batches;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells()[c];
    if (!batches.empty() && batches.back() == c / batch_size) continue;
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index node) { return constraints.find(node); }))
      batches.push_back(c / batch_size);
  }
  return batches;
}

Eigen::VectorXd residual(const Problem& problem, const Constraints& constraints, const Eigen::VectorXd& load,
                         const Iterate& iterate) {
  Eigen::VectorXd result = load - iterate.force;
  const auto tools = driven_tools(problem);
  for (const auto& constraint : constraints.nodes) {
    if (constraint.friction_tool < 0) continue;
    const Point along = constraint.basis.col(dim - 1);
    const auto k = std::find(tools.begin(), tools.end(), constraint.friction_tool);
    const double wall =
        k == tools.end() ? problem.tools[constraint.friction_tool].velocity : iterate.driven[k - tools.begin()];
    const double slip = along.dot(node_velocity(iterate.x, constraint.node) - wall * core::axis_direction());
    result.segment<dim>(dim * constraint.node) -=
        (constraints.tangential_stiffness[constraint.node] * slip + constraints.tangential_load[constraint.node]) *
        along;
  }
  return result;
}

double backward_error(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                      const Eigen::VectorXd& load, Iterate& iterate) {
  const Eigen::MatrixXd product_and_scale = product_and_size(*problem.mesh, cells, iterate.x);
  iterate.force = product_and_scale.col(0);
  const Eigen::VectorXd scale = product_and_scale.col(1) + load.cwiseAbs();
  Eigen::VectorXd defect = residual(problem, constraints, load, iterate);
  for (const auto& constraint : constraints.nodes)
    for (int a = 0; a < dim; ++a)
      if (constraint.fixed[a]) {
        auto there = defect.segment<dim>(dim * constraint.node);
        there -= (constraint.basis.col(a).dot(there) * constraint.basis.col(a)).eval();
      }
  double largest = 0;
  for (Index i = 0; i < defect.size(); ++i)
    if (defect[i] != 0) largest = std::max(largest, std::abs(defect[i]) / scale[i]);
  return largest;
}

}  // namespace parison::flow
