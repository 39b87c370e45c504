// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/solid_flow.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/flow/step_parts.hpp"
#include "forming/solid/flow/tool_contact.hpp"

namespace parison::flow {

namespace {

constexpr double volume_tolerance = 1e-9;
constexpr int hold_friction_after = 20;       ///< solutions; where friction settles it does in about ten
constexpr double viscosity_tolerance = 2e-3;  ///< mean change of ln eta, of glass that thins by shear
constexpr int most_viscosities = 12;          ///< each halves the change, about, with an exponent of 0.5
constexpr double steady_share = 0.25;         ///< largest change of a velocity that goes on
constexpr double worst_volume = 0.1;          ///< of a cell, beyond which a step is too long
constexpr double most_strain = 0.5;           ///< of a step that is not repeated

/// Velocities of the first half of a step, in which they go on as they changed between the last two steps; where they
/// changed much, and where glass touches a tool anywhere, those of the last: there what was seen is how glass landed.
Eigen::VectorXd first_half(const SolidGlass& glass, double dt) {
  const bool touches = std::any_of(glass.contact.begin(), glass.contact.end(), [](const auto& c) { return c.touches; });
  if (touches || glass.velocity_before.size() != glass.velocity.size()) return glass.velocity;
  const double ahead = (0.25 * dt + 0.5 * glass.last_step) / (0.5 * (glass.last_step + glass.step_before));
  Eigen::VectorXd result = glass.velocity;
  for (Index n = 0; 3 * n < result.size(); ++n) {
    const Vector3 change = ahead * (glass.velocity - glass.velocity_before).segment<3>(3 * n);
    if (change.norm() < steady_share * glass.velocity.segment<3>(3 * n).norm()) result.segment<3>(3 * n) += change;
  }
  return result;
}

/// Integrals of the pressure functions times an expansion of each cell.
Eigen::VectorXd integrals(const FlowMatrix& matrix, const Eigen::VectorXd& rate) {
  Eigen::VectorXd result(4 * rate.size());
  for (Index cell = 0; cell < rate.size(); ++cell) result.segment<4>(4 * cell) = rate[cell] * matrix.moment(cell);
  return result;
}

/// The density of a cell over that at the reference, from the mean of its nodes by volume.
Eigen::VectorXd densities(const Material& material, const HexMesh& mesh, const Eigen::VectorXd& temperature) {
  Eigen::VectorXd density = Eigen::VectorXd::Constant(mesh.cell_count(), material.density);
  if (material.relative_density.x.empty()) return density;
  constexpr int points = 3;
  const core::HexRule& rule = core::hex_rule(points, points);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const core::HexNodes nodes = core::cell_nodes(mesh, cell);
    core::HexShape own;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) own[n] = temperature[mesh.cells[cell][n]];
    double mass = 0, volume = 0;
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
      const double part = core::map_hex_point(nodes, rule, q).volume;
      volume += part;
      mass += part * material.relative_density(rule.shape.col(static_cast<Index>(q)).dot(own));
    }
    density[cell] *= mass / volume;
  }
  return density;
}

}  // namespace

Eigen::VectorXd volumes_by_mass(const Material& material, const SolidGlass& glass) {
  return glass.cell_mass.cwiseQuotient(densities(material, glass.mesh, glass.temperature));
}

Eigen::VectorXd masses_by_volume(const Material& material, const HexMesh& mesh, const Eigen::VectorXd& temperature) {
  return core::cell_volumes(mesh).cwiseProduct(densities(material, mesh, temperature));
}

namespace {

/// Of a step, from one velocity to the next with the same matrix.
struct Motion {
  const FlowMatrix& matrix;
  const HexMesh& start;
  const Eigen::VectorXd& volumes;  ///< wanted at the end, m3
  double dt;
  Eigen::VectorXd velocity, pressure;

  /// What the volumes lack at the end, m3.
  Eigen::VectorXd lack() const { return volumes - core::cell_volumes(moved(start, velocity, dt)); }
  /// The largest lack, and moment of it within a cell, as a share of its volume.
  double error(const Eigen::VectorXd& lacking) const {
    const Eigen::VectorXd flux = matrix.divergence(velocity);
    double worst = 0;
    for (Index cell = 0; cell < volumes.size(); ++cell) {
      const Eigen::Vector4d& moment = matrix.moment(cell);
      const Eigen::Vector4d rest = flux.segment<4>(4 * cell) - moment * (flux[4 * cell] / moment[0]);
      const double own = std::max(std::abs(lacking[cell]), dt * rest.norm()) / volumes[cell];
      worst = own <= worst ? worst : own;  // not a number counts
    }
    return worst;
  }
  /// Solves for the velocity with which the volumes lack nothing, but for what the motion bends meanwhile.
  void solve(const Eigen::VectorXd& force, const Eigen::VectorXd& lacking) {
    const Eigen::VectorXd flux = matrix.divergence(velocity);
    Eigen::VectorXd rate(volumes.size());
    for (Index cell = 0; cell < volumes.size(); ++cell)
      rate[cell] = (flux[4 * cell] + lacking[cell] / dt) / matrix.moment(cell)[0];
    const Eigen::VectorXd wanted = integrals(matrix, rate);
    velocity = matrix.solve(force, pressure, wanted);
    pressure = matrix.corrected_pressure(velocity, pressure, wanted);
  }
};

/// Calls visit(cell, volume, gradient of the velocity) for points of each cell.
template <typename Visit>
void for_each_rate(const HexMesh& mesh, const Eigen::VectorXd& velocity, const Visit& visit) {
  constexpr int points = 2;
  const core::HexRule& rule = core::hex_rule(points, points);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const core::HexNodes nodes = core::cell_nodes(mesh, cell);
    core::HexNodes own;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) own.col(n) = velocity.segment<3>(3 * mesh.cells[cell][n]);
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
      const core::HexPoint point = core::map_hex_point(nodes, rule, q);
      visit(cell, point.volume, own * point.gradient.transpose());
    }
  }
}

/// By how much the viscosity of glass that thins by shear differs between two velocities: the mean of its logarithm's
/// change over what is dissipated.
double change_of_viscosity(const Carreau& law, const FlowMatrix& matrix, const HexMesh& mesh,
                           const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
  std::vector<double> factor;
  for_each_rate(mesh, before,
                [&](Index, double, const Eigen::Matrix3d& slope) { factor.push_back(law(squared_shear_rate(slope))); });
  double sum = 0, power = 0;
  std::size_t at = 0;
  for_each_rate(mesh, after, [&](Index cell, double volume, const Eigen::Matrix3d& slope) {
    const double rate = squared_shear_rate(slope), part = volume * rate * matrix.mean_viscosity(cell);
    sum += part * std::abs(std::log(law(rate) / factor[at++]));
    power += part;
  });
  return power > 0 ? sum / power : 0;
}

/// Solves until contact and volumes are right.
void balance(ToolContact& contact, FlowMatrix& matrix, const Eigen::VectorXd& force, Motion& motion, SolidStep& step) {
  contact.add_changes(matrix);
  matrix.factorise();
  int factors = 1, solutions = 0;
  Eigen::VectorXd lacking = motion.lack();
  while (solutions < most_solutions) {
    motion.solve(force + contact.forces(), lacking);
    if (++solutions == hold_friction_after) contact.hold_friction();
    contact.look(motion.velocity);
    lacking = motion.lack();
    step.volume_error = motion.error(lacking);
    if (!(step.volume_error <= worst_volume)) break;
    if (factors < most_factors && solutions < hold_friction_after && contact.choose() > 0) {
      contact.add_changes(matrix);
      matrix.factorise();
      ++factors;
      continue;
    }
    if (step.volume_error <= volume_tolerance && contact.friction_change() <= friction_tolerance) break;
  }
  step.factors += factors;
  step.solutions += solutions;
}

/// Balances forces with the viscosity at the velocities that come out: by iterates with that of the ones before.
ToolContact balance_thinned(const SolidProblem& problem, FlowMatrix& matrix, const HexMesh& middle,
                            const SolidGlass& glass, Motion& motion, SolidStep& step) {
  const auto& thinning = problem.material->shear_thinning;
  const bool has_contact = glass.contact.size() == contact_points_per_face * problem.contact_faces.size();
  for (int pass = 1;; ++pass) {
    const Eigen::VectorXd expected = motion.velocity;
    matrix.assemble(problem, middle, glass.temperature, expected);
    ToolContact contact(problem, matrix, glass.mesh, middle, glass.temperature, expected,
                        has_contact ? &glass.contact : nullptr, motion.dt,
                        std::max(glass.last_step, glass.step_before));
    balance(contact, matrix, loads(problem, matrix, middle, glass.cell_mass), motion, step);
    if (!thinning || pass == most_viscosities || !(step.volume_error <= volume_tolerance) ||
        change_of_viscosity(*thinning, matrix, middle, expected, motion.velocity) <= viscosity_tolerance)
      return contact;
  }
}

}  // namespace

SolidStep step_flow(const SolidProblem& problem, FlowMatrix& matrix, SolidGlass& glass, double dt) {
  SolidStep step;
  step.dt = dt;
  if (glass.velocity.size() == 0) {  // at rest: what touches holds the glass
    glass.velocity = Eigen::VectorXd::Zero(3 * glass.mesh.node_count());
    glass.pressure = Eigen::VectorXd::Zero(4 * glass.mesh.cell_count());
  }
  if (glass.pressure.size() == 0) glass.pressure = Eigen::VectorXd::Zero(4 * glass.mesh.cell_count());
  const HexMesh middle = moved(glass.mesh, first_half(glass, dt), 0.5 * dt);
  if (is_folded(middle)) return step;
  const Eigen::VectorXd volumes = volumes_by_mass(*problem.material, glass);
  Motion motion{matrix, glass.mesh, volumes, dt, glass.velocity, glass.pressure};
  const ToolContact contact = balance_thinned(problem, matrix, middle, glass, motion, step);
  step.strain = dt * strain_rate(middle, motion.velocity);
  HexMesh end = moved(glass.mesh, motion.velocity, dt);
  if (!(step.strain < most_strain) || !(step.volume_error <= volume_tolerance) || is_folded(end)) return step;
  step.accepted = true;
  step.tool_forces = contact.tool_forces();
  glass.contact = contact.contact();
  glass.mesh.nodes = std::move(end.nodes);
  glass.velocity_before = std::exchange(glass.velocity, std::move(motion.velocity));
  glass.step_before = std::exchange(glass.last_step, dt);
  glass.pressure = std::move(motion.pressure);
  return step;
}

double strain_rate(const HexMesh& mesh, const Eigen::VectorXd& velocity) {
  double worst = 0;
  for_each_rate(mesh, velocity, [&](Index, double, const Eigen::Matrix3d& slope) {
    worst = std::max(worst, squared_shear_rate(slope));
  });
  return std::sqrt(worst / 3);
}

double propose_step(const SolidProblem& problem, const SolidGlass& glass, const SolidStepLimits& limits) {
  double dt = glass.last_step > 0 ? std::min(limits.longest, limits.growth * glass.last_step) : limits.longest;
  if (glass.velocity.size() == 0) return dt;
  if (const double rate = strain_rate(glass.mesh, glass.velocity); rate > 0) dt = std::min(dt, limits.strain / rate);
  for (const HexFace& face : problem.contact_faces) {
    const auto nodes = core::face_node_numbers(glass.mesh, face);
    for (const auto& at : core::map_hex_face(core::face_nodes(glass.mesh, face), face, contact_points_along)) {
      Vector3 velocity = Vector3::Zero();
      for (int n = 0; n < 9; ++n) velocity += at.shape[n] * glass.velocity.segment<3>(3 * nodes[n]);
      for (const SolidTool& tool : problem.tools) {
        const contact::SurfaceGap gap = tool.surface->gap(at.position - tool.offset);
        const double closing = -gap.normal.dot(velocity - tool.velocity);
        if (gap.distance > 0 && closing * dt > gap.distance + limits.landing)
          dt = (gap.distance + limits.landing) / closing;
      }
    }
  }
  return dt;
}

}  // namespace parison::flow
