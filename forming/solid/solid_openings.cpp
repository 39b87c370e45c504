// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_openings.hpp"

#include <algorithm>
#include <cmath>

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/solid_step.hpp"
#include "forming/step/heat/contact_opening.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// Calls work(index into SolidGlass::contact, numbers of the face's nodes, point) for each point of contact.
template <typename Work>
void for_contact_points(const core::HexMesh& mesh, const std::vector<core::HexFace>& faces, const Work& work) {
  std::size_t index = 0;
  for (const core::HexFace& face : faces) {
    const auto nodes = core::face_node_numbers(mesh, face);
    for (const auto& point : core::map_hex_face(core::face_nodes(mesh, face), face, flow::contact_points_along))
      work(index++, nodes, point);
  }
}

double value_at(const Eigen::VectorXd& nodal, const std::array<Index, 9>& nodes, const core::HexFacePoint& point) {
  double value = 0;
  for (int n = 0; n < 9; ++n) value += point.shape[n] * nodal[nodes[n]];
  return value;
}

/// The law of a gap that a place of the glass has with a tool of the present stage, and its interface.
struct GapContact {
  const Interface* interface = nullptr;
  const contact::GapConductance* law = nullptr;
};
GapContact gap_contact(const Scene& scene, Index stage, Index tool) {
  for (const Interface& interface : scene.interfaces)
    if (interface.tool == tool && scene.stages[stage].uses(tool))
      return {&interface, std::get_if<contact::GapConductance>(&interface.law)};
  return {};
}

/// Openings of a round surface by its nodes, without those at tools that the stage has not.
Eigen::VectorXd kept_openings(const Scene& scene, const State& state) {
  Eigen::VectorXd opening = state.glass.contact_opening;
  for (Index n = 0; n < opening.size(); ++n)
    if (const Index tool = state.glass.contact_tool[n]; tool >= 0 && !scene.stages[scene.solid->from_stage].uses(tool))
      opening[n] = 0;
  return opening;
}

/// Between the ends of the edge whose chord is nearest to a place.
double opening_at(const core::Mesh& mesh, const Eigen::VectorXd& opening, const Point& at) {
  double nearest = HUGE_VAL, value = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    const Point &first = mesh.nodes[edge.nodes[0]], along = mesh.nodes[edge.nodes[1]] - first;
    const double share = std::clamp((at - first).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double square = (first + share * along - at).squaredNorm();
    if (square >= nearest) continue;
    nearest = square;
    value = (1 - share) * opening[edge.nodes[0]] + share * opening[edge.nodes[1]];
  }
  return value;
}

}  // namespace

void take_openings(const Scene& scene, const State& state, SolidState& solid) {
  if (!scene.has_gap_law()) return;
  const Eigen::VectorXd opening = kept_openings(scene, state);
  solid.contact_opening.resize(static_cast<Index>(solid.faces.size()) * flow::contact_points_per_face);
  for_contact_points(solid.glass.mesh, solid.faces, [&](std::size_t index, const auto&, const auto& point) {
    const Point at(point.position.template head<2>().norm(), point.position[2]);
    solid.contact_opening[static_cast<Index>(index)] = opening_at(state.glass.mesh, opening, at);
  });
}

void set_opening(const Scene& scene, const SolidState& solid, const Interface& interface, std::size_t point,
                 double temperature, contact::ContactState& contact) {
  const auto* law = std::get_if<contact::GapConductance>(&interface.law);
  if (!law) return;
  contact.opening = solid.contact_opening[static_cast<Index>(point)];
  contact.closing_rate = closing_rate(scene, *law, contact.pressure, temperature);
}

void advance_openings(const Scene& scene, const State& clock, double dt, const flow::SolidGlass& before,
                      SolidState& solid) {
  if (!scene.has_gap_law()) return;
  const Eigen::VectorXd temperature = 0.5 * (before.temperature + solid.glass.temperature);
  for_contact_points(solid.glass.mesh, solid.faces, [&](std::size_t index, const auto& nodes, const auto& point) {
    const flow::SolidContact& contact = solid.glass.contact[index];
    double& opening = solid.contact_opening[static_cast<Index>(index)];
    const SolidTool* tool = contact.tool < 0 ? nullptr : &solid.tools[static_cast<std::size_t>(contact.tool)];
    const auto [interface, law] = tool ? gap_contact(scene, clock.stage, tool->tool) : GapContact{};
    const double gap = contact.touches ? std::min(contact.gap, 0.0) : contact.gap;
    if (!law || gap >= interface->transition_gap) {
      opening = 0;
      return;
    }
    double share = 1;
    if (opening == 0) {
      const double place = tool_offset(scene, clock, tool->tool, clock.stage_time);
      Vector3 at = -place * Vector3::UnitZ();
      for (int n = 0; n < 9; ++n) at += point.shape[n] * before.mesh.nodes[nodes[n]];
      share = share_in_contact(tool->surface->gap(at).distance, gap, interface->transition_gap);
    }
    const double rate = closing_rate(scene, *law, contact.pressure, value_at(temperature, nodes, point));
    opening = law->opening_after(opening, rate, share * dt);
  });
}

}  // namespace parison::forming
