// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/air_regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace parison::forming {

bool is_inner(const SolidState& solid, std::size_t face) {
  return solid.heat_faces[face].boundary_id == static_cast<Index>(SolidSide::inner);
}

/// Faces with a point that does not touch.
std::vector<bool> exposed_faces(const SolidState& solid) {
  std::vector<bool> exposed(solid.faces.size(), true);
  if (solid.glass.contact.empty()) return exposed;
  for (std::size_t f = 0; f < exposed.size(); ++f) {
    const auto first = solid.glass.contact.begin() + static_cast<std::ptrdiff_t>(f * flow::contact_points_per_face);
    exposed[f] =
        !std::all_of(first, first + flow::contact_points_per_face, [](const auto& point) { return point.touches; });
  }
  return exposed;
}

/// The faces beside each face.
std::vector<std::vector<std::size_t>> face_neighbours(const SolidState& solid) {
  std::vector<std::vector<std::size_t>> beside(solid.faces.size());
  std::map<Index, std::size_t> seen;  // by the node in the middle of an edge
  for (std::size_t f = 0; f < beside.size(); ++f)
    for (const std::size_t middle : {1, 3, 5, 7}) {
      const auto [at, is_new] = seen.emplace(solid.heat_faces[f].nodes[middle], f);
      if (is_new) continue;
      beside[f].push_back(at->second);
      beside[at->second].push_back(f);
    }
  return beside;
}

namespace {

/// Ends of the contact surfaces of tools that no other tool closes: in the plane of their outlines, m.
std::vector<Point> loose_ends(const std::vector<CavityTool>& tools, double seal_gap) {
  std::vector<Point> ends;
  for (const CavityTool& own : tools) {
    const auto contact = contact_boundaries(*own.tool);
    const auto& segments = own.tool->profile.segments;
    for (std::size_t s = 0; s < segments.size(); ++s) {
      const core::Segment& next = segments[(s + 1) % segments.size()];
      if (contact[segments[s].boundary_id] == contact[next.boundary_id]) continue;
      const Point at = segments[s].end + own.from * core::axis_direction();
      const bool is_closed =
          at[0] <= seal_gap || std::any_of(tools.begin(), tools.end(), [&](const CavityTool& other) {
            const Point local = at - other.from * core::axis_direction();
            return other.tool != own.tool && (core::contains(other.tool->profile, local) ||
                                              core::distance(other.tool->profile, local) <= seal_gap);
          });
      if (!is_closed) ends.push_back(at);
    }
  }
  return ends;
}

AirRegions hanging_together(const SolidState& solid, const std::vector<bool>& exposed,
                            const std::vector<std::vector<std::size_t>>& beside) {
  AirRegions regions{std::vector<Index>(exposed.size(), -1), {}, {}};
  for (std::size_t first = 0; first < exposed.size(); ++first) {
    if (!exposed[first] || is_inner(solid, first) || regions.of_face[first] >= 0) continue;
    const auto number = static_cast<Index>(regions.faces.size());
    std::vector<std::size_t> faces{first};
    regions.of_face[first] = number;
    bool open = false;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const std::size_t next : beside[faces[i]]) {
        open = open || (exposed[next] && is_inner(solid, next));
        if (!exposed[next] || is_inner(solid, next) || regions.of_face[next] >= 0) continue;
        regions.of_face[next] = number;
        faces.push_back(next);
      }
    regions.faces.push_back(std::move(faces));
    regions.open.push_back(open);
  }
  return regions;
}

/// Opens the regions nearest to the loose ends of the tools.
void open_at_loose_ends(const SolidState& solid, const std::vector<Point>& ends, AirRegions& regions) {
  for (const Point& end : ends) {
    double nearest = HUGE_VAL;
    Index region = -1;
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
      if (is_inner(solid, f)) continue;
      const core::Vector3& at = solid.glass.mesh.nodes[solid.heat_faces[f].nodes[4]];
      const double distance = (Point(at.head<2>().norm(), at[2]) - end).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      region = regions.of_face[f];
    }
    if (region >= 0) regions.open[static_cast<std::size_t>(region)] = true;
  }
}

}  // namespace

AirRegions exposed_regions(const SolidState& solid, const std::vector<bool>& exposed,
                           const std::vector<std::vector<std::size_t>>& beside, const std::vector<CavityTool>& tools,
                           double seal_gap) {
  AirRegions regions = hanging_together(solid, exposed, beside);
  open_at_loose_ends(solid, loose_ends(tools, seal_gap), regions);
  return regions;
}

}  // namespace parison::forming
