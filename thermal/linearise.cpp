// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/linearise.hpp"

#include "thermal/shapes.hpp"

namespace parison::thermal {

namespace {

template <int N>
void linearise_cell(const BodyLaws& laws, const HeatCell& cell, const Eigen::VectorXd& temperature,
                    CellSlopes& slopes) {
  const CellShapes<N>& shapes = cell_shapes<N>();
  const auto T = gather<N>(temperature, cell.unknowns);
  const PointArray at = shapes.value * T, along_a = shapes.slope_a * T, along_b = shapes.slope_b * T;
  const PointArray dk_dT = laws.conductivity.slope(at, cell.thin_wall);
  slopes = {cell.mass * laws.enthalpy.capacity(at), laws.conductivity(at, cell.thin_wall),
            dk_dT * (cell.aa * along_a + cell.ab * along_b), dk_dT * (cell.ab * along_a + cell.bb * along_b)};
}

template <int N>
void apply_cell(const HeatCell& cell, const CellSlopes& slopes, double step, const Eigen::VectorXd& change,
                Eigen::VectorXd& result) {
  const CellShapes<N>& shapes = cell_shapes<N>();
  const auto d = gather<N>(change, cell.unknowns);
  const PointArray at = shapes.value * d, along_a = shapes.slope_a * d, along_b = shapes.slope_b * d;
  const PointArray& k = slopes.conductivity;
  const PointArray flow_a = step * (k * (cell.aa * along_a + cell.ab * along_b) + slopes.flow_a * at);
  const PointArray flow_b = step * (k * (cell.ab * along_a + cell.bb * along_b) + slopes.flow_b * at);
  const PointArray stored = slopes.capacity * at;
  scatter<N>(shapes.value.transpose() * stored.matrix() + shapes.slope_a.transpose() * flow_a.matrix() +
                 shapes.slope_b.transpose() * flow_b.matrix(),
             cell.unknowns, result);
}

ContactSlopes linearise_contact(const HeatSystem& system, const HeatContact& contact,
                                const Eigen::VectorXd& temperature) {
  const core::InterfacePoint& point = *contact.point;
  const double closed = point.closure * point.area;
  if (closed == 0) return {};
  const double T1 = interpolate(temperature, contact.unknowns.data(), contact.slave_shape);
  const double T2 = interpolate(temperature, contact.unknowns.data() + 3, contact.master_shape);
  const core::Conductance law = system.problem->law(point, T1);
  return {closed * law.h, closed * law.dh_dT * (T1 - T2),
          contact.slave_air ? closed * surface_flux(*contact.slave_air, T1).dq_dT : 0,
          contact.master_air ? closed * surface_flux(*contact.master_air, T2).dq_dT : 0};
}

}  // namespace

Linearisation linearise(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  Linearisation result;
  result.cells.resize(system.cells.size());
  const auto cell = system.problem->order == 2 ? linearise_cell<6> : linearise_cell<3>;
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c) cell(laws, system.cells[c], temperature, result.cells[c]);
  for (const HeatEdge& edge : system.edges) {
    auto& slopes = result.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      slopes[q] = edge.area[q] * surface_flux(edge.exchange, T).dq_dT;
    }
  }
  for (const HeatContact& contact : system.contacts)
    result.contacts.push_back(linearise_contact(system, contact, temperature));
  return result;
}

Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(system.size());
  const auto cell = system.problem->order == 2 ? apply_cell<6> : apply_cell<3>;
  for (std::size_t c = 0; c < system.cells.size(); ++c)
    cell(system.cells[c], linearisation.cells[c], step, change, result);
  const auto add = [&](const Index* unknowns, const std::array<double, 3>& shape, double heat) {
    for (int i = 0; i < 3; ++i) result[unknowns[i]] += step * shape[i] * heat;
  };
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    for (int q = 0; q < 3; ++q)
      add(edge.unknowns.data(), edge.shape[q],
          linearisation.edges[e][q] * interpolate(change, edge.unknowns.data(), edge.shape[q]));
  }
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const HeatContact& contact = system.contacts[i];
    const ContactSlopes& slopes = linearisation.contacts[i];
    const Index *slave = contact.unknowns.data(), *master = slave + 3;
    const double d1 = interpolate(change, slave, contact.slave_shape);
    const double d2 = interpolate(change, master, contact.master_shape);
    const double across = slopes.across * (d1 - d2) + slopes.conductance * d1;
    add(slave, contact.slave_shape, across - slopes.slave_air * d1);
    add(master, contact.master_shape, -across - slopes.master_air * d2);
  }
  return result;
}

}  // namespace parison::thermal
