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
  scatter<N>(shapes.value.transpose() * stored.matrix(), cell.unknowns, response.content);
  scatter<N>(shapes.slope_a.transpose() * flow_a.matrix() + shapes.slope_b.transpose() * flow_b.matrix(),
             cell.unknowns, response.power);
}

void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate,
               Response& response) {
  const auto add = system.problem->order == 2 ? add_cell<6> : add_cell<3>;
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c) add(laws, system.cells[c], temperature, rate, response);
}

/// Air exchange and interface; `power` may be null.
void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power) {
  const auto take = [&](const Index* unknowns, const auto& shape, double heat) {
    if (power)
      for (int i = 0; i < 3; ++i) (*power)[unknowns[i]] -= shape[i] * heat;
  };
  for (const HeatEdge& edge : system.edges)
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      const double heat = edge.area[q] * surface_flux(edge.exchange, T).q;
      flows.to_air[edge.body] += heat;
      take(edge.unknowns.data(), edge.shape[q], heat);
    }
  for (const HeatContact& contact : system.contacts) {
    const core::InterfacePoint& point = *contact.point;
    const double closed = point.closure * point.area;
    if (closed == 0) continue;
    const Index *slave = contact.unknowns.data(), *master = slave + 3;
    const double T1 = interpolate(temperature, slave, contact.slave_shape);
    const double T2 = interpolate(temperature, master, contact.master_shape);
    const double across = closed * system.problem->law(point, T1).h * (T1 - T2);
    const double slave_air = contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).q : 0;
    const double master_air = contact.master_air ? closed * surface_flux(*contact.master_air, T2).q : 0;
    for (int i = 0; i < 3; ++i) {
      flows.across[contact.pair] += contact.slave_shape[i] * across;
      flows.received[contact.pair] += contact.master_shape[i] * across;
    }
    flows.to_air[point.slave_body] -= slave_air;
    flows.to_air[point.master_body] -= master_air;
    take(slave, contact.slave_shape, across - slave_air);
    take(master, contact.master_shape, -across - master_air);
  }
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
