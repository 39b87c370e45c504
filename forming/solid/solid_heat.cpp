// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_heat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "contact/solid/solid_conductance.hpp"
#include "contact/solid/solid_mortar.hpp"
#include "core/mesh/element.hpp"
#include "core/solid/hex_element.hpp"
#include "forming/solid/solid_openings.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/heat/surroundings.hpp"
#include "forming/step/heat/thermal_interface.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// Area of the mouth over that of the inner side: by reciprocity the share of the mouth in what the inner side sees.
double mouth_share(const SolidState& solid) {
  double mouth = 0, inner = 0;
  for (const core::QuadFace& face : solid.heat_faces) {
    if (face.boundary_id != static_cast<Index>(SolidSide::inner)) continue;
    for (const auto& a : core::edge_rule(3))
      for (const auto& b : core::edge_rule(3)) {
        const Vector3 area = a.weight * b.weight * core::face_place(solid.glass.mesh.nodes, face, a.s, b.s).area();
        mouth += area[2];
        inner += area.norm();
      }
  }
  return inner > 0 ? std::min(1.0, std::abs(mouth) / inner) : 0;
}

/// What the surface of the glass has around it, by SolidSide: the air and, of light in bands, black surroundings of its
/// ambient temperature. With an enclosure the inner side sees them through the mouth, and else itself.
void surround_glass(const Scene& scene, const State& clock, const SolidState& solid, thermal::SolidBodyView& glass) {
  thermal::SurfaceExchange outside = air_at_glass(scene, clock, false), inside = air_at_glass(scene, clock, true);
  if (scene.has_light()) {
    outside.emissivity = inside.emissivity = 0;
    glass.light = {{inside.ambient_temperature, outside.ambient_temperature, outside.ambient_temperature},
                   scene.glass.emissivity};
    if (scene.enclosure) glass.own_view = {1 - mouth_share(solid), 0, 0};
  }
  glass.exchange = {inside, outside, outside};
}

thermal::SolidBodyView tool_body(const Scene& scene, const State& clock, const SolidTool& tool) {
  const Body& data = scene.tools[tool.tool];
  auto body = thermal::solid_body(tool.mesh, tool.mass, *data.thermal);
  body.light.emissivity = data.emissivity;
  if (is_waiting(scene, clock.stage, tool.tool)) return body;
  const core::Mesh& section = clock.tools[tool.tool].mesh;
  body.exchange = surroundings(scene, clock, body_of_tool(tool.tool), section);
  for (std::size_t b = 0; b < section.boundaries().size(); ++b) {
    const bool given = section.boundaries()[b].kind == BoundaryKind::temperature;
    body.prescribed.push_back(given ? std::optional(data.boundaries[b].temperature) : std::nullopt);
  }
  return body;
}

/// For the nine-point face of each (axis, end): the places of the flow's contact points in the unit cube.
class ContactPlaces {
 public:
  /// The contact point of a face that lies nearest to a place (a, b) of its heat face.
  std::size_t nearest(const core::HexFace& face, const std::array<double, 2>& at) {
    const Vector3 place = core::cube_place(face, at[0], at[1]);
    const auto& points = of(face);
    std::size_t best = 0;
    for (std::size_t p = 1; p < points.size(); ++p)
      if ((points[p] - place).squaredNorm() < (points[best] - place).squaredNorm()) best = p;
    return best;
  }

 private:
  const std::vector<Vector3>& of(const core::HexFace& face) {
    auto& points = places_[{face.axis, face.end}];
    if (!points.empty()) return points;
    // The faces of a cube have their points where its rule has them.
    core::HexFaceNodes nodes;
    const auto& numbers = core::hex_face_nodes(face.axis, face.end);
    for (int i = 0; i < 9; ++i) nodes.col(i) = 0.5 * Vector3(numbers[i] % 3, (numbers[i] / 3) % 3, numbers[i] / 9);
    for (const auto& point : core::map_hex_face(nodes, face, flow::contact_points_along))
      points.push_back(point.position);
    return points;
  }
  std::map<std::array<int, 2>, std::vector<Vector3>> places_;
};

/// Of the glass at a place of one of its faces, K.
double temperature_at(const SolidState& solid, Index face, const std::array<double, 2>& at) {
  const auto shape = core::quad_shape(at[0], at[1]);
  double temperature = 0;
  for (std::size_t n = 0; n < shape.size(); ++n)
    temperature += shape[n] * solid.glass.temperature[solid.heat_faces[face].nodes[n]];
  return temperature;
}

/// The virtual surface between the glass and the tools that are in place, at the present positions.
core::SolidInterface solid_interface(const Scene& scene, const State& clock, const SolidState& solid,
                                     std::vector<std::vector<Vector3>>& moved) {
  const auto slave = contact::solid_surface(glass_body, solid.glass.mesh.nodes, solid.heat_faces);
  std::vector<contact::SolidMaster> masters;
  ContactPlaces places;
  for (std::size_t t = 0; t < solid.tools.size(); ++t) {
    const SolidTool& tool = solid.tools[t];
    const auto law = std::find_if(scene.interfaces.begin(), scene.interfaces.end(),
                                  [&](const Interface& one) { return one.tool == tool.tool; });
    if (law == scene.interfaces.end() || !scene.stages[clock.stage].uses(tool.tool)) continue;
    const Vector3 offset = clock.tools[tool.tool].offset * Vector3::UnitZ();
    for (const Vector3& x : tool.mesh.nodes) moved[t].push_back(x + offset);
    std::vector<Index> touching;
    for (std::size_t b = 0; b < scene.tools[tool.tool].boundaries.size(); ++b)
      if (scene.tools[tool.tool].boundaries[b].kind == BoundaryKind::contact) touching.push_back(static_cast<Index>(b));
    masters.push_back({contact::solid_surface(1 + static_cast<Index>(t), moved[t], tool.mesh.faces, touching),
                       static_cast<Index>(law - scene.interfaces.begin()), law->transition_gap,
                       [&, t, offset, law](Index face, const std::array<double, 2>& at) {
                         const auto place =
                             core::face_place(solid.glass.mesh.nodes, solid.heat_faces[face], at[0], at[1]);
                         const double gap = solid.tools[t].surface->gap(place.position - offset).distance;
                         const std::size_t index =
                             face * flow::contact_points_per_face + places.nearest(solid.faces[face], at);
                         const auto& contact = solid.glass.contact[index];
                         const bool presses = contact.touches && contact.tool == static_cast<Index>(t);
                         contact::ContactState state{presses ? std::min(gap, 0.0) : gap,
                                                     presses ? std::max(0.0, contact.pressure) : 0};
                         set_opening(scene, solid, *law, index, temperature_at(solid, face, at), state);
                         return state;
                       }});
  }
  if (masters.empty() || solid.glass.contact.empty()) return {};
  return contact::build_interface(slave, masters);
}

/// Thickness of the wall at each node, m: the length of its column.
Eigen::VectorXd column_lengths(const SolidState& solid) {
  Eigen::VectorXd length(solid.glass.mesh.node_count());
  for (const auto& column : solid.columns) {
    const double of_column = (solid.glass.mesh.nodes[column.back()] - solid.glass.mesh.nodes[column.front()]).norm();
    for (const Index node : column) length[node] = of_column;
  }
  return length;
}

/// Adds what a step exchanged to the sums.
void add_balance(const thermal::HeatBalance& balance, SolidState& solid) {
  const thermal::BodyBalance& glass = balance.bodies[glass_body];
  solid.totals.to_air += glass.to_air;
  solid.totals.to_tools += thermal::lost_through_interfaces(balance, glass_body);
  solid.totals.light_to_air += glass.light_to_air;
  for (const thermal::PairBalance& pair : balance.pairs) solid.totals.light_to_tools += pair.radiated;
  solid.totals.heat_imbalance += std::abs(thermal::imbalance(balance, glass_body));
  for (std::size_t t = 0; t < solid.tools.size(); ++t)
    solid.tools[t].heat_received -= thermal::lost_through_interfaces(balance, 1 + static_cast<Index>(t));
}

}  // namespace

std::string advance_solid_heat(const Scene& scene, const State& clock, double dt, SolidState& solid,
                               thermal::SolidStepMatrix& matrix) {
  thermal::SolidProblem problem;
  problem.bodies.push_back(
      thermal::solid_body(solid.glass.mesh, solid.heat_faces, solid.point_mass, *scene.glass.thermal));
  problem.bodies.front().stacks = &solid.stacks;
  surround_glass(scene, clock, solid, problem.bodies.front());
  const Eigen::VectorXd thickness = column_lengths(solid);
  if (thermal::is_rosseland(*scene.glass.thermal)) problem.bodies.front().wall_thickness = &thickness;
  std::vector<Eigen::VectorXd> temperature{solid.glass.temperature};
  for (const SolidTool& tool : solid.tools) {
    problem.bodies.push_back(tool_body(scene, clock, tool));
    temperature.push_back(tool.temperature);
  }
  std::vector<std::vector<Vector3>> moved(solid.tools.size());
  long clamped = 0;
  problem.interface = solid_interface(scene, clock, solid, moved);
  const auto points = contact::conductance_points(problem.interface.points);
  problem.law = thermal::in_space(interface_law(scene, points, clock.time, clamped), points);
  const auto options = heat_options(scene, solid.heat_substep);
  auto outcome = thermal::advance(problem, clock.time, temperature, dt, options, matrix);
  if (!outcome.converged) return outcome.reason;
  solid.temperature_rate = (outcome.temperature.front() - solid.glass.temperature) / dt;
  solid.glass.temperature = std::move(outcome.temperature.front());
  for (std::size_t t = 0; t < solid.tools.size(); ++t)
    if (!is_waiting(scene, clock.stage, solid.tools[t].tool))
      solid.tools[t].temperature = std::move(outcome.temperature[1 + t]);
  solid.heat_substep = outcome.next_substep;
  add_balance(outcome.balance, solid);
  return "";
}

void keep_heat(const thermal::SolidBodyView& body, double heat, const Eigen::VectorXd& shape,
               Eigen::VectorXd& temperature) {
  constexpr int steps = 4;
  constexpr double apart = 1;  // K
  for (int i = 0; i < steps; ++i) {
    const double now = thermal::heat_content(body, temperature);
    const double capacity = (thermal::heat_content(body, temperature + apart * shape) - now) / apart;
    temperature += (heat - now) / capacity * shape;
  }
}

}  // namespace parison::forming
