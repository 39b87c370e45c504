// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cavities/air_cavities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/mesh/element.hpp"
#include "core/mesh/tolerances.hpp"

namespace parison::forming {

namespace {

/// Consecutive exposed edges of a loop of the glass boundary, and the edges before and after them.
struct Arc {
  std::vector<Index> edges;
  Index before, after;
};

bool touches(const ExposedGlass& glass, Index node) {
  return glass.contact_tool[node] >= 0;
}

/// Maximal runs of exposed edges; a node in contact between two of them parts them. Loops without any contact have
/// none.
std::vector<Arc> find_arcs(const ExposedGlass& glass) {
  const auto& edges = glass.mesh.boundary_edges();
  const core::BoundaryChain chain(glass.mesh);
  const auto starts = [&](Index e) {
    return glass.exposed[e] && (!glass.exposed[chain.previous[e]] || touches(glass, edges[e].nodes[0]));
  };
  std::vector<Arc> arcs;
  for (Index e = 0; e < static_cast<Index>(edges.size()); ++e) {
    if (!starts(e)) continue;
    Arc arc{{e}, chain.previous[e], 0};
    for (arc.after = chain.next[e]; arc.after != e && glass.exposed[arc.after] && !starts(arc.after);
         arc.after = chain.next[arc.after])
      arc.edges.push_back(arc.after);
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

bool is_symmetry(const core::Mesh& mesh, Index edge) {
  return mesh.kind_of(mesh.boundary_edges()[edge]) == core::BoundaryKind::symmetry;
}

/// Direction of a straight boundary edge, unit.
Point direction(const core::Mesh& mesh, Index edge) {
  const auto& nodes = mesh.boundary_edges()[edge].nodes;
  return (mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).normalized();
}

/// The places of tools at a glass node in contact.
std::vector<OutlinePlace> places_at(const ToolOutlines& outlines, Index tool, const Point& x, double tolerance) {
  std::vector<OutlinePlace> places;
  std::optional<ToolOutlines::Nearest> own;
  for (Index run = 0; run < static_cast<Index>(outlines.runs.size()); ++run) {
    const auto nearest = outlines.nearest(run, x);
    const bool of_tool = outlines.runs[run].tool == tool;
    if (of_tool && (!own || nearest.distance < own->distance)) own = nearest;
    if (!of_tool && nearest.distance <= tolerance) places.push_back(nearest.place);
  }
  if (own) places.insert(places.begin(), own->place);
  return places;
}

/// The outline of a region with the region on the right adds up to its volume.
class VolumeIntegral {
 public:
  explicit VolumeIntegral(core::Geometry geometry) : geometry_(geometry) {}

  void add_chord(const Point& a, const Point& b) {
    const double rise = b[1] - a[1];
    volume_ -= geometry_ == core::Geometry::planar ? 0.5 * (a[0] + b[0]) * rise
                                                   : M_PI / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * rise;
  }
  void add_edge(const core::Mesh& mesh, const core::BoundaryEdge& edge) {
    for (const auto& rule : core::edge_rule(4)) {
      const auto shape = core::edge_shape(rule.s), slope = core::edge_shape_derivative(rule.s);
      double r = 0, rise = 0;
      for (int i = 0; i < 3; ++i) {
        r += shape[i] * mesh.nodes[edge.nodes[i]][0];
        rise += slope[i] * mesh.nodes[edge.nodes[i]][1];
      }
      volume_ -= rule.weight * rise * (geometry_ == core::Geometry::planar ? r : M_PI * r * r);
    }
  }
  /// Change of the volume per metre by which a chord moves along the axis, m2.
  double area_across_axis(const Point& a, const Point& b) const {
    return geometry_ == core::Geometry::planar ? b[0] - a[0] : M_PI * (b[0] * b[0] - a[0] * a[0]);
  }
  double volume() const { return volume_; }

 private:
  core::Geometry geometry_;
  double volume_ = 0;
};

/// Joins arcs to cavities by walks along the tools.
class CavitySearch {
 public:
  CavitySearch(const ExposedGlass& glass, const ToolOutlines& outlines, Index tool_count, double seal_gap)
      : glass_(glass),
        tool_count_(tool_count),
        tolerance_(core::tolerance::junction * core::size(glass.mesh)),
        arcs_(find_arcs(glass)),
        scene_{outlines, seal_gap, {}, {}} {
    for (Index a = 0; a < static_cast<Index>(arcs_.size()); ++a) add_target(a);
    for (Index a = 0; a < static_cast<Index>(arcs_.size()); ++a) walks_.push_back(walk_from(a));
  }

  std::vector<AirCavity> cavities() const {
    std::vector<AirCavity> found;
    std::vector<bool> seen(arcs_.size(), false);
    for (Index a = 0; a < static_cast<Index>(arcs_.size()); ++a) {
      if (seen[a]) continue;
      const auto ring = arcs_around(a);
      for (const Index member : ring) seen[member] = true;
      if (!ring.empty()) found.push_back(cavity(ring));
    }
    return found;
  }

 private:
  void add_target(Index a) {
    const Arc& arc = arcs_[a];
    const Index node = glass_.mesh.boundary_edges()[arc.edges.front()].nodes[0];
    const Point& x = glass_.mesh.nodes[node];
    if (touches(glass_, node)) {
      for (const auto& place : places_at(scene_.outlines, glass_.contact_tool[node], x, tolerance_))
        scene_.targets.push_back({place, a, node});
    } else if (is_symmetry(glass_.mesh, arc.before)) {
      scene_.line_targets.push_back({x, direction(glass_.mesh, arc.before), a});
    }
  }

  Walk walk_from(Index a) const {
    const Arc& arc = arcs_[a];
    const Index node = glass_.mesh.boundary_edges()[arc.edges.back()].nodes[1];
    const Point& x = glass_.mesh.nodes[node];
    if (!touches(glass_, node))
      return is_symmetry(glass_.mesh, arc.after) ? walk_line(scene_, x, -direction(glass_.mesh, arc.after)) : Walk{};
    const auto places = places_at(scene_.outlines, glass_.contact_tool[node], x, tolerance_);
    return places.empty() ? Walk{} : walk_outlines(scene_, places.front(), node);
  }

  /// The arcs that the walks join into a ring from arc a on; empty where they do not come back to it.
  std::vector<Index> arcs_around(Index a) const {
    std::vector<Index> ring{a};
    for (Index next = walks_[a].arc; next != a; next = walks_[next].arc) {
      if (next < 0 || std::count(ring.begin(), ring.end(), next)) return {};
      ring.push_back(next);
    }
    return ring;
  }

  AirCavity cavity(const std::vector<Index>& ring) const {
    AirCavity result;
    result.tool_area.assign(tool_count_, 0.0);
    VolumeIntegral integral(glass_.geometry);
    for (const Index a : ring) add_arc(a, integral, result);
    result.volume = integral.volume();
    return result;
  }

  void add_arc(Index a, VolumeIntegral& integral, AirCavity& cavity) const {
    const auto& edges = glass_.mesh.boundary_edges();
    Point at = Point::Zero();
    for (const Index e : arcs_[a].edges) {
      cavity.edges.push_back(e);
      integral.add_edge(glass_.mesh, edges[e]);
      for (const auto& rule : core::edge_rule(2))
        cavity.exposed_area += core::map_edge_point(glass_.mesh, edges[e].nodes, glass_.geometry, rule).area;
      at = glass_.mesh.nodes[edges[e].nodes[1]];
    }
    for (const auto& piece : walks_[a].pieces) {
      integral.add_chord(at, piece.from);
      integral.add_chord(piece.from, piece.to);
      if (piece.tool >= 0) cavity.tool_area[piece.tool] += integral.area_across_axis(piece.from, piece.to);
      at = piece.to;
    }
    const Index next = arcs_[walks_[a].arc].edges.front();
    integral.add_chord(at, glass_.mesh.nodes[edges[next].nodes[0]]);
  }

  const ExposedGlass& glass_;
  Index tool_count_;
  double tolerance_;
  std::vector<Arc> arcs_;
  WalkScene scene_;
  std::vector<Walk> walks_;
};

}  // namespace

std::vector<bool> exposed_edges(const core::Mesh& mesh, const std::vector<Index>& contact_tool) {
  std::vector<bool> exposed;
  for (const auto& edge : mesh.boundary_edges()) {
    const auto kind = mesh.kind_of(edge);
    const bool surface = kind == core::BoundaryKind::contact || kind == core::BoundaryKind::air;
    exposed.push_back(surface && std::any_of(edge.nodes.begin(), edge.nodes.end(),
                                             [&](Index node) { return contact_tool[node] < 0; }));
  }
  return exposed;
}

std::vector<AirCavity> air_cavities(const ExposedGlass& glass, const ToolOutlines& outlines, Index tool_count,
                                    double seal_gap) {
  return CavitySearch(glass, outlines, tool_count, seal_gap).cavities();
}

}  // namespace parison::forming
