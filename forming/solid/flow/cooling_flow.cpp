// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "forming/solid/flow/solid_flow.hpp"
#include "forming/solid/flow/step_parts.hpp"
#include "forming/solid/flow/tool_contact.hpp"

namespace parison::flow {

SolidStep step_cooling(const SolidProblem& problem, FlowMatrix& matrix, SolidGlass& glass, double dt) {
  SolidStep step;
  step.dt = dt;
  const Index nodes = glass.mesh.node_count();
  const Eigen::VectorXd expected = glass.velocity.size() > 0 ? glass.velocity : Eigen::VectorXd::Zero(3 * nodes);
  const HexMesh middle = moved(glass.mesh, expected, 0.5 * dt);
  matrix.assemble(problem, middle, glass.temperature, expected);
  ToolContact contact(problem, matrix, glass.mesh, middle, glass.temperature, expected,
                      glass.contact.empty() ? nullptr : &glass.contact, dt,
                      std::max(glass.last_step, glass.step_before));
  const Eigen::VectorXd force = loads(problem, matrix, middle, glass.cell_mass) + matrix.memory_force();
  Eigen::VectorXd velocity;
  const auto factorise = [&] {
    contact.add_changes(matrix);
    matrix.factorise();
    ++step.factors;
  };
  factorise();
  while (step.solutions < most_solutions) {
    velocity = matrix.solve(force + contact.forces(), glass.pressure, matrix.memory_expansion());
    ++step.solutions;
    contact.look(velocity);
    if (step.factors < most_factors && contact.choose() > 0)
      factorise();
    else if (contact.friction_change() <= friction_tolerance)
      break;
  }
  HexMesh end = moved(glass.mesh, velocity, dt);
  step.strain = dt * strain_rate(middle, velocity);
  if (!velocity.allFinite() || is_folded(end)) return step;
  step.accepted = true;
  step.tool_forces = contact.tool_forces();
  glass.pressure = matrix.corrected_pressure(velocity, glass.pressure, matrix.memory_expansion());
  glass.contact = contact.contact();
  glass.mesh.nodes = std::move(end.nodes);
  glass.velocity_before = expected;
  glass.velocity = std::move(velocity);
  glass.step_before = std::exchange(glass.last_step, dt);
  return step;
}

}  // namespace parison::flow
