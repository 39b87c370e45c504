// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light_heat.hpp"

#include <limits>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// What lies outside of the surface and what group and temperatures send.
struct GroupState {
  GroupSource source;
  std::vector<double> surroundings;             ///< irradiation in equilibrium with them, W/m2, by boundary
  std::vector<std::array<double, 3>> at_edges;  ///< the same with what lies outside of the points of the edges
  Eigen::ArrayXd tool;                          ///< the same with the tool, by point of the interface
};

/// By boundary of the glass, K; zero where it sees none.
std::vector<double> surroundings_at(const Light& light, const HeatSystem& system, double time) {
  const auto& surroundings = system.problem->bodies[light.body].light.surroundings;
  std::vector<double> temperature;
  temperature.reserve(surroundings.size());
  for (const auto& given : surroundings) temperature.push_back(given ? (*given)(time) : 0);
  return temperature;
}

/// Irradiation in equilibrium with what lies outside of a point of an edge: the surroundings, or a black wall of the
/// glass's temperature.
double outside_of(const Light& light, const LightEdge& edge, int q, int group, const std::vector<double>& surroundings,
                  const Eigen::VectorXd& temperature) {
  if (!edge.black) return surroundings[edge.boundary];
  return light.laws().irradiation(group, at_point(temperature, edge.temperature, edge.shape[q].data())).value;
}

/// What the patches of the enclosure and their surroundings emit in a group.
PatchEmission patches_of(const Light& light, const HeatSystem& system, int group, double time,
                         const Eigen::VectorXd& temperature) {
  if (!light.enclosure) return {};
  const Enclosure& enclosure = *system.enclosure;
  const auto emission = [&](double T) { return light.laws().emissive_power(group, T).value; };
  return {patch_means(enclosure,
                      [&](std::size_t i) {
                        const EnclosurePoint& point = enclosure.points[i];
                        return emission(interpolate(temperature, point.unknowns.data(), point.shape));
                      }),
          surroundings_of(enclosure, time, emission)};
}

GroupState state_of(const Light& light, const HeatSystem& system, int group, const std::vector<double>& surroundings,
                    const Eigen::ArrayXd& tool_temperature, const Eigen::VectorXd& temperature, const Field& at_cells) {
  const LightLaws& laws = light.laws();
  GroupState state{{}, {}, {}, Eigen::ArrayXd(tool_temperature.size())};
  for (const double T : surroundings) state.surroundings.push_back(laws.irradiation(group, T).value);
  state.source.cells = emission_at(light, group, at_cells, &Emission::value);
  for (const LightEdge& edge : light.edges) {
    auto &outside = state.at_edges.emplace_back(), &sent = state.source.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      outside[q] = outside_of(light, edge, q, group, state.surroundings, temperature);
      sent[q] = light.coefficient(group, edge) * edge.area[q] * outside[q];
    }
  }
  state.source.contacts.resize(tool_temperature.size());
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const LightContact& contact = light.contacts[i];
    const auto at = static_cast<Index>(i);
    state.tool[at] = laws.irradiation(group, tool_temperature[at]).value;
    state.source.contacts[at] =
        system.interface.area[at] * (light.to_tool(group, contact) * state.tool[at] -
                                     light.open(group, contact) * state.surroundings[contact.boundary]);
  }
  return state;
}

/// Adds a group's flux out of the surface to the flows, and to the power into the tools.
void add_group_flux(const Light& light, const HeatSystem& system, int group, const GroupState& state,
                    const GroupLight& found, Flows& flows, Eigen::ArrayXd& to_tool) {
  for (std::size_t e = 0; e < light.edges.size(); ++e)
    for (int q = 0; q < 3; ++q)
      flows.to_air[light.body] += light.coefficient(group, light.edges[e]) * light.edges[e].area[q] *
                                  (found.edges[e][q] - state.at_edges[e][q]);
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const LightContact& contact = light.contacts[i];
    const auto at = static_cast<Index>(i);
    const double area = system.interface.area[at], G = found.contacts[at];
    flows.to_air[light.body] -= light.open(group, contact) * area * (G - state.surroundings[contact.boundary]);
    to_tool[at] += light.to_tool(group, contact) * area * (G - state.tool[at]);
  }
}

/// Adds what the opaque bands give off at the surface.
void add_opaque(const Light& light, const HeatSystem& system, const std::vector<double>& surroundings,
                const SideTemperatures& sides, const Eigen::VectorXd& temperature, Flows& flows,
                Eigen::ArrayXd& to_tool, Eigen::VectorXd* power) {
  const LightLaws& laws = light.laws();
  const double emissivity = system.problem->bodies[light.body].light.emissivity;
  std::vector<double> around;
  around.reserve(surroundings.size());
  for (const double T : surroundings) around.push_back(laws.opaque_emission(T).value);
  for (const LightEdge& edge : light.edges)
    for (int q = 0; q < 3 && !edge.black; ++q) {
      const double T = at_point(temperature, edge.temperature, edge.shape[q].data());
      const double heat = emissivity * edge.area[q] * (laws.opaque_emission(T).value - around[edge.boundary]);
      flows.to_air[light.body] += heat;
      if (power) add_at_point(-heat, edge.temperature, edge.shape[q].data(), *power);
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

void multiply_by_absorption(const Light& light, int group, Field& values) {
  const double absorption = light.laws().group(group).absorption;
  const Field* relative = light.relative_of(group);
  for (std::size_t g = 0; g < values.size(); ++g)
    for (int q = 0; q < core::cell_points; ++q) {
      values[g][q] *= absorption * light.volumes[g][q];
      if (relative) values[g][q] *= (*relative)[g][q];
    }
}

Field emission_at(const Light& light, int group, const Field& temperature, double Emission::*part) {
  Field emitted(temperature.size());
  const LightLaws& laws = light.laws();
  for (std::size_t g = 0; g < emitted.size(); ++g)
    for (int q = 0; q < core::cell_points; ++q)
      for (int lane = 0; lane < core::batch_size; ++lane)
        emitted[g][q][lane] = laws.irradiation(group, temperature[g][q][lane]).*part;
  multiply_by_absorption(light, group, emitted);
  return emitted;
}

Field at_cell_points(const Light& light, const HeatSystem& system, const Eigen::VectorXd& temperature) {
  return at_points(system.batches.data() + system.bodies[light.body].first_batch, light.batches.size(),
                   temperature.data());
}

namespace {

/// Irradiation of a group by P1, by unknown, W/m2.
Eigen::VectorXd solve_p1(const Light& light, int group, const GroupSource& source) {
  if (!light.solvable) return Eigen::VectorXd::Constant(light.size, std::numeric_limits<double>::quiet_NaN());
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(light.size);
  for (std::size_t e = 0; e < light.edges.size(); ++e)
    for (int q = 0; q < 3; ++q)
      add_at_point(source.edges[e][q], light.edges[e].light, light.edges[e].shape[q].data(), rhs);
  for (std::size_t i = 0; i < light.contacts.size(); ++i)
    add_at_point(source.contacts[static_cast<Index>(i)], light.contacts[i].light, light.contacts[i].shape.data(), rhs);
  add_from_points(light.batches.data(), source.cells, rhs.data());
  return light.kept->factor[group].solve(rhs);
}

}  // namespace

GroupLight solve_group(const Light& light, int group, const GroupSource& source) {
  if (light.rays) return ray_light(light, group, source);
  const Eigen::VectorXd G = solve_p1(light, group, source);
  GroupLight found{at_points(light.batches.data(), light.batches.size(), G.data()),
                   {},
                   Eigen::ArrayXd(static_cast<Index>(light.contacts.size()))};
  multiply_by_absorption(light, group, found.absorbed);
  for (const LightEdge& edge : light.edges) {
    auto& at = found.edges.emplace_back();
    for (int q = 0; q < 3; ++q) at[q] = at_point(G, edge.light, edge.shape[q].data());
  }
  for (std::size_t i = 0; i < light.contacts.size(); ++i)
    found.contacts[static_cast<Index>(i)] = at_point(G, light.contacts[i].light, light.contacts[i].shape.data());
  return found;
}

void add_absorbed(const Light& light, const HeatSystem& system, const GroupSource& source, const GroupLight& found,
                  double factor, Eigen::VectorXd& power) {
  Field gained = found.absorbed;
  for (std::size_t g = 0; g < gained.size(); ++g)
    for (int q = 0; q < core::cell_points; ++q) gained[g][q] = factor * (gained[g][q] - source.cells[g][q]);
  add_from_points(system.batches.data() + system.bodies[light.body].first_batch, gained, power.data());
}

void add_light(const Light& light, const HeatSystem& system, double time, const Eigen::VectorXd& temperature,
               Flows& flows, Eigen::VectorXd* power) {
  const std::vector<double> surroundings = surroundings_at(light, system, time);
  const SideTemperatures sides = side_temperatures(system.interface, temperature);
  const double to_air_before = flows.to_air[light.body];
  const Field at_cells = at_cell_points(light, system, temperature);
  Eigen::ArrayXd to_tool = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(light.contacts.size()));
  for (int k = 0; k < light.laws().group_count(); ++k) {
    GroupState state = state_of(light, system, k, surroundings, sides.master, temperature, at_cells);
    state.source.patches = patches_of(light, system, k, time, temperature);
    const GroupLight found = solve_group(light, k, state.source);
    add_group_flux(light, system, k, state, found, flows, to_tool);
    if (light.enclosure)
      add_excess(*system.enclosure, system, absorbed_excess(light, system, found), flows, power, light.body);
    if (power) add_absorbed(light, system, state.source, found, 1, *power);
  }
  if (light.laws().has_opaque()) add_opaque(light, system, surroundings, sides, temperature, flows, to_tool, power);
  add_to_tools(system, to_tool, flows, power);
  flows.light_to_air[light.body] += flows.to_air[light.body] - to_air_before;
}

Eigen::MatrixXd irradiation(const Light& light, const HeatSystem& system, double time,
                            const Eigen::VectorXd& temperature) {
  Eigen::MatrixXd G(light.size, light.laws().group_count());
  const SideTemperatures sides = side_temperatures(system.interface, temperature);
  const Field at_cells = at_cell_points(light, system, temperature);
  for (int k = 0; k < light.laws().group_count(); ++k)
    G.col(k) = solve_p1(
        light, k,
        state_of(light, system, k, surroundings_at(light, system, time), sides.master, temperature, at_cells).source);
  return G;
}

}  // namespace parison::thermal
