// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/shapes.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Conduction of one cell, and its content (or, with `rate`, the rate of its content).
template <int N>
void add_cell(const BodyLaws& laws, const HeatCell& cell, const Eigen::VectorXd& temperature,
              const Eigen::VectorXd* rate, Response& response) {
  const CellShapes<N>& shapes = cell_shapes<N>();
  const auto T = gather<N>(temperature, cell.unknowns);
  const PointArray at = shapes.value * T, along_a = shapes.slope_a * T, along_b = shapes.slope_b * T;
  const PointArray k = laws.conductivity(at, cell.thin_wall);
  const PointArray flow_a = -k * (cell.aa * along_a + cell.ab * along_b);
  const PointArray flow_b = -k * (cell.ab * along_a + cell.bb * along_b);
  PointArray stored;
  if (rate)
    stored = laws.enthalpy.capacity(at) * (shapes.value * gather<N>(*rate, cell.unknowns)).array();
  else
    stored = laws.enthalpy.enthalpy(at);
  stored *= cell.mass;
  scatter<N>(shapes.value_back * stored.matrix(), cell.unknowns, response.content);
  scatter<N>(shapes.slope_a_back * flow_a.matrix() + shapes.slope_b_back * flow_b.matrix(),
             cell.unknowns, response.power);
}

void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate,
               Response& response) {
  const auto add = system.problem->order == 2 ? add_cell<6> : add_cell<3>;
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c) add(laws, system.cells[c], temperature, rate, response);
}

Flows zero_flows(const HeatSystem& system) {
  const auto bodies = static_cast<Index>(system.bodies.size()), pairs = static_cast<Index>(system.pairs.size());
  Flows flows{Eigen::VectorXd::Zero(bodies), Eigen::VectorXd::Zero(bodies),
              Eigen::VectorXd::Zero(pairs), Eigen::VectorXd::Zero(pairs)};
  for (Index b = 0; b < bodies; ++b)
    if (system.problem->bodies[b].source)
      for (const double source : *system.problem->bodies[b].source) flows.from_source[b] += source;
  return flows;
}

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate) {
  Response response{Eigen::VectorXd::Zero(system.size()), system.source, zero_flows(system)};
  add_cells(system, temperature, rate, response);
  add_exchange(system, temperature, response.flows, &response.power);
  return response;
}

}  // namespace

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  return evaluate(system, temperature, nullptr);
}

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd& rate) {
  return evaluate(system, temperature, &rate);
}

Flows evaluate_flows(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  Flows flows = zero_flows(system);
  add_exchange(system, temperature, flows, nullptr);
  return flows;
}

}  // namespace parison::thermal
