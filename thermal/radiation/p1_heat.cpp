// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/p1_heat.hpp"

#include <limits>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Flux between the surface and what is outside of it of one group.
struct GroupFlux {
  Eigen::VectorXd irradiation;       ///< W/m2, by unknown
  std::vector<double> surroundings;  ///< irradiation in equilibrium with them, W/m2, by boundary
  Eigen::ArrayXd tool;               ///< in equilibrium with the tool, W/m2, by point of the interface
};

/// By boundary of the glass, K; zero where it sees none.
std::vector<double> surroundings_at(const P1& light, const HeatSystem& system, double time) {
  std::vector<double> temperature;
  for (const auto& given : system.problem->bodies[light.body].light.surroundings)
    temperature.push_back(given ? (*given)(time) : 0);
  return temperature;
}

/// Irradiation in equilibrium with what lies outside of a point of an edge: the surroundings, or a black wall of the
/// glass's temperature.
double outside_of(const P1& light, const LightEdge& edge, int q, int group, const GroupFlux& flux,
                  const Eigen::VectorXd& temperature) {
  if (!edge.black) return flux.surroundings[edge.boundary];
  return light.laws()
      .irradiation(group, at_point(temperature, edge.temperature, edge.temperature_shape[q].data()))
      .value;
}

Field emission_at(const P1& light, int group, const Field& temperature) {
  Field emitted(temperature.size());
  const LightLaws& laws = light.laws();
  for (std::size_t g = 0; g < emitted.size(); ++g)
    for (int q = 0; q < core::cell_points; ++q) {
      for (int lane = 0; lane < core::batch_size; ++lane)
        emitted[g][q][lane] = laws.irradiation(group, temperature[g][q][lane]).value;
      emitted[g][q] *= laws.group(group).absorption * light.volumes[g][q];
    }
  return emitted;
}

/// Solves a group; `emitted` gets what its cells emit, W at the quadrature points.
GroupFlux solve(const P1& light, const HeatSystem& system, int group, const std::vector<double>& surroundings,
                const Eigen::ArrayXd& tool_temperature, const Eigen::VectorXd& temperature, const Field& at_cells,
                Field& emitted) {
  const LightLaws& laws = light.laws();
  GroupFlux flux{{}, {}, Eigen::ArrayXd(tool_temperature.size())};
  for (const double T : surroundings) flux.surroundings.push_back(laws.irradiation(group, T).value);
  for (Index i = 0; i < static_cast<Index>(tool_temperature.size()); ++i)
    flux.tool[i] = laws.irradiation(group, tool_temperature[i]).value;
  emitted = emission_at(light, group, at_cells);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(light.size);
  for (const LightEdge& edge : light.edges)
    for (int q = 0; q < 3; ++q)
      add_at_point(light.coefficient(group, edge) * edge.area[q] * outside_of(light, edge, q, group, flux, temperature),
                   edge.light, edge.light_shape[q].data(), rhs);
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const LightContact& contact = light.contacts[i];
    const auto at = static_cast<Index>(i);
    const double given = light.to_tool(group, contact) * flux.tool[at] -
                         light.open(group, contact) * flux.surroundings[contact.boundary];
    add_at_point(system.interface.area[at] * given, contact.light, contact.shape.data(), rhs);
  }
  flux.irradiation = solve_group(light, group, emitted, std::move(rhs));
  return flux;
}

/// Adds a group's flux out of the surface to the flows, and to the power into the tools.
void add_group_flux(const P1& light, const HeatSystem& system, int group, const GroupFlux& flux,
                    const Eigen::VectorXd& temperature, Flows& flows, Eigen::ArrayXd& to_tool) {
  for (const LightEdge& edge : light.edges)
    for (int q = 0; q < 3; ++q)
      flows.to_air[light.body] += light.coefficient(group, edge) * edge.area[q] *
                                  (at_point(flux.irradiation, edge.light, edge.light_shape[q].data()) -
                                   outside_of(light, edge, q, group, flux, temperature));
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const LightContact& contact = light.contacts[i];
    const auto at = static_cast<Index>(i);
    const double G = at_point(flux.irradiation, contact.light, contact.shape.data());
    flows.to_air[light.body] -=
        light.open(group, contact) * system.interface.area[at] * (G - flux.surroundings[contact.boundary]);
    to_tool[at] += light.to_tool(group, contact) * system.interface.area[at] * (G - flux.tool[at]);
  }
}

/// Adds what the opaque bands give off at the surface.
void add_opaque(const P1& light, const HeatSystem& system, const std::vector<double>& surroundings,
                const SideTemperatures& sides, const Eigen::VectorXd& temperature, Flows& flows,
                Eigen::ArrayXd& to_tool, Eigen::VectorXd* power) {
  const LightLaws& laws = light.laws();
  const double emissivity = system.problem->bodies[light.body].light.emissivity;
  std::vector<double> around;
  for (const double T : surroundings) around.push_back(laws.opaque_emission(T).value);
  for (const LightEdge& edge : light.edges)
    for (int q = 0; q < 3 && !edge.black; ++q) {
      const double T = at_point(temperature, edge.temperature, edge.temperature_shape[q].data());
      const double heat = emissivity * edge.area[q] * (laws.opaque_emission(T).value - around[edge.boundary]);
      flows.to_air[light.body] += heat;
      if (power) add_at_point(-heat, edge.temperature, edge.temperature_shape[q].data(), *power);
    }
  for (const HeatSegment& segment : system.interface.segments)
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const LightContact& contact = light.contacts[i];
      const double area = system.interface.area[i], own = laws.opaque_emission(sides.slave[i]).value;
      const double to_air = contact.opaque_open * area * (own - around[contact.boundary]);
      const double across = contact.opaque * area * (own - laws.opaque_emission(sides.master[i]).value);
      flows.to_air[light.body] -= to_air;
      to_tool[i] += across;
      if (!power) continue;
      for (int k = 0; k < 3; ++k) (*power)[segment.unknowns[k]] += system.interface.shape(k, i) * (to_air - across);
    }
}

/// Gives the tools what has gone to them.
void add_to_tools(const HeatSystem& system, const Eigen::ArrayXd& to_tool, Flows& flows, Eigen::VectorXd* power) {
  for (const HeatSegment& segment : system.interface.segments)
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      flows.across[segment.pair] += to_tool[i];
      flows.radiated[segment.pair] += to_tool[i];
      for (int k = 3; k < 6; ++k) {
        const double heat = system.interface.shape(k, i) * to_tool[i];
        flows.received[segment.pair] += heat;
        if (power) (*power)[segment.unknowns[k]] += heat;
      }
    }
}

}  // namespace

Field at_cell_points(const P1& light, const HeatSystem& system, const Eigen::VectorXd& temperature) {
  return at_points(system.batches.data() + system.bodies[light.body].first_batch, light.batches.size(),
                   system.problem->order, temperature.data());
}

Eigen::VectorXd solve_group(const P1& light, int group, const Field& emitted, Eigen::VectorXd rhs) {
  if (!light.solvable) return Eigen::VectorXd::Constant(light.size, std::numeric_limits<double>::quiet_NaN());
  add_from_points(light.batches.data(), emitted, light.order, rhs.data());
  return light.kept->factor[group].solve(rhs);
}

void add_absorbed(const P1& light, const HeatSystem& system, const std::vector<Eigen::VectorXd>& irradiation,
                  const std::vector<Field>& emitted, double factor, Eigen::VectorXd& power) {
  Field absorbed(light.batches.size());
  for (std::size_t k = 0; k < irradiation.size(); ++k) {
    const Field G = at_points(light.batches.data(), light.batches.size(), light.order, irradiation[k].data());
    const double scale = factor * light.laws().group(static_cast<int>(k)).absorption;
    for (std::size_t g = 0; g < absorbed.size(); ++g)
      for (int q = 0; q < core::cell_points; ++q)
        absorbed[g][q] += scale * light.volumes[g][q] * G[g][q] - factor * emitted[k][g][q];
  }
  add_from_points(system.batches.data() + system.bodies[light.body].first_batch, absorbed, system.problem->order,
                  power.data());
}

void add_light(const P1& light, const HeatSystem& system, double time, const Eigen::VectorXd& temperature, Flows& flows,
               Eigen::VectorXd* power) {
  const std::vector<double> surroundings = surroundings_at(light, system, time);
  const SideTemperatures sides = side_temperatures(system.interface, temperature);
  const double to_air_before = flows.to_air[light.body];
  const Field at_cells = at_cell_points(light, system, temperature);
  std::vector<Eigen::VectorXd> G;
  std::vector<Field> emitted(light.laws().group_count());
  Eigen::ArrayXd to_tool = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(light.contacts.size()));
  for (int k = 0; k < light.laws().group_count(); ++k) {
    GroupFlux flux = solve(light, system, k, surroundings, sides.master, temperature, at_cells, emitted[k]);
    add_group_flux(light, system, k, flux, temperature, flows, to_tool);
    G.push_back(std::move(flux.irradiation));
  }
  if (power) add_absorbed(light, system, G, emitted, 1, *power);
  if (light.laws().has_opaque()) add_opaque(light, system, surroundings, sides, temperature, flows, to_tool, power);
  add_to_tools(system, to_tool, flows, power);
  flows.light_to_air[light.body] += flows.to_air[light.body] - to_air_before;
}

Eigen::MatrixXd irradiation(const P1& light, const HeatSystem& system, double time,
                            const Eigen::VectorXd& temperature) {
  Eigen::MatrixXd G(light.size, light.laws().group_count());
  const SideTemperatures sides = side_temperatures(system.interface, temperature);
  Field emitted;
  for (int k = 0; k < light.laws().group_count(); ++k)
    G.col(k) = solve(light, system, k, surroundings_at(light, system, time), sides.master, temperature,
                     at_cell_points(light, system, temperature), emitted)
                   .irradiation;
  return G;
}

}  // namespace parison::thermal
