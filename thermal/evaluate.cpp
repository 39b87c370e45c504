// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/shapes.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Conduction and source of one cell, and its content (or, with `rate`, the rate of its content).
void add_cell(const BodyLaws& laws, const HeatCell& cell, const Eigen::VectorXd& temperature,
              const Eigen::VectorXd* rate, Response& response) {
  const CellShapes& shapes = cell_shapes();
  std::array<double, 6> T, dT{}, content{}, power{};
  for (int i = 0; i < 6; ++i) T[i] = temperature[cell.unknowns[i]];
  if (rate)
    for (int i = 0; i < 6; ++i) dT[i] = (*rate)[cell.unknowns[i]];
  for (int q = 0; q < 6; ++q) {
    const HeatPoint& point = cell.points[q];
    double at = 0, change = 0;
    core::Point slope = core::Point::Zero();
    for (int i = 0; i < 6; ++i) {
      at += shapes[q][i] * T[i];
      change += shapes[q][i] * dT[i];
      slope += point.gradient[i] * T[i];
    }
    const EnthalpyValue enthalpy = laws.enthalpy(at);
    const double stored = point.mass * (rate ? enthalpy.c * change : enthalpy.h);
    const core::Point flow = -conductivity(*laws.material, at, point.thin_wall) * point.volume * slope;
    for (int i = 0; i < 6; ++i) {
      content[i] += shapes[q][i] * stored;
      power[i] += flow.dot(point.gradient[i]) + shapes[q][i] * point.source;
    }
  }
  for (int i = 0; i < 6; ++i) {
    response.content[cell.unknowns[i]] += content[i];
    response.power[cell.unknowns[i]] += power[i];
  }
}

void add_cells(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate,
               Response& response) {
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c)
      add_cell(laws, system.cells[c], temperature, rate, response);
}

/// Air exchange and interface; `power` may be null.
void add_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Flows& flows, Eigen::VectorXd* power) {
  const EdgeShapes& shapes = edge_shapes();
  const auto take = [&](const Index* unknowns, const auto& shape, double heat) {
    if (power)
      for (int i = 0; i < 3; ++i) (*power)[unknowns[i]] -= shape[i] * heat;
  };
  for (const HeatEdge& edge : system.edges)
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), shapes[q]);
      const double heat = edge.area[q] * surface_flux(edge.exchange, T).q;
      flows.to_air[edge.body] += heat;
      take(edge.unknowns.data(), shapes[q], heat);
    }
  for (const HeatContact& contact : system.contacts) {
    const core::InterfacePoint& point = *contact.point;
    const double closed = point.closure * point.area;
    if (closed == 0) continue;
    const Index *slave = contact.unknowns.data(), *master = slave + 3;
    const double T1 = interpolate(temperature, slave, point.slave_shape);
    const double T2 = interpolate(temperature, master, point.master_shape);
    const double across = closed * system.problem->law(point, T1).h * (T1 - T2);
    const double slave_air = contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).q : 0;
    const double master_air = contact.master_air ? closed * surface_flux(*contact.master_air, T2).q : 0;
    flows.across[contact.pair] += across;
    flows.to_air[point.slave_body] -= slave_air;
    flows.to_air[point.master_body] -= master_air;
    take(slave, point.slave_shape, across - slave_air);
    take(master, point.master_shape, -across - master_air);
  }
}

Flows zero_flows(const HeatSystem& system) {
  const auto bodies = static_cast<Index>(system.bodies.size());
  Flows flows{Eigen::VectorXd::Zero(bodies), Eigen::VectorXd::Zero(bodies),
              Eigen::VectorXd::Zero(static_cast<Index>(system.pairs.size()))};
  for (Index b = 0; b < bodies; ++b)
    if (system.problem->bodies[b].source)
      for (const double source : *system.problem->bodies[b].source) flows.from_source[b] += source;
  return flows;
}

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate) {
  Response response{Eigen::VectorXd::Zero(system.size()), Eigen::VectorXd::Zero(system.size()), zero_flows(system)};
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
