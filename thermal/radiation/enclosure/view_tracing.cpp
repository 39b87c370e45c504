// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/view_tracing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

constexpr double moved_far = 1;     ///< of the length of a patch, before views are traced anew
constexpr double most_lost = 0.01;  ///< share of what all open surfaces send, before they are refused

std::vector<Point> placed_nodes(const BodyView& body) {
  std::vector<Point> nodes = body.mesh->nodes;
  for (Point& x : nodes) x += body.light.offset * core::axis_direction();
  return nodes;
}

/// Divides the open surface into patches of one boundary each; the edges of all bodies, which may hide each other.
std::vector<OpenEdge> divide(const HeatSystem& system, const TracedViews& traced, Index& patches) {
  const EdgeAreas &open = traced.edge_open, &full = traced.edge_full;
  std::vector<OpenEdge> edges;
  patches = 0;
  for (std::size_t b = 0; b < open.size(); ++b) {
    const BodyView& body = system.problem->bodies[b];
    double so_far = 0;
    Index last = -1;
    for (std::size_t e = 0; e < open[b].size() && body.light.in_place; ++e) {
      const core::BoundaryEdge& edge = body.mesh->boundary_edges()[e];
      OpenEdge& added = edges.emplace_back(OpenEdge{static_cast<Index>(b), static_cast<Index>(e), -1});
      const bool is_open = full[b][e] > 0 && open[b][e] > covered * full[b][e];
      if (!is_open) {
        last = -1;
        continue;
      }
      const double own = (traced.nodes[b][edge.nodes[1]] - traced.nodes[b][edge.nodes[0]]).norm();
      if (last != edge.boundary_id || so_far + 0.5 * own > traced.patch_length) ++patches, so_far = 0;
      so_far += own;
      last = edge.boundary_id;
      added.patch = patches - 1;
    }
  }
  return edges;
}

double open_length(const HeatSystem& system, const TracedViews& traced) {
  const EdgeAreas &open = traced.edge_open, &full = traced.edge_full;
  double length = 0;
  for (std::size_t b = 0; b < open.size(); ++b) {
    const core::Mesh& mesh = *system.problem->bodies[b].mesh;
    for (std::size_t e = 0; e < open[b].size(); ++e)
      if (full[b][e] > 0 && open[b][e] > covered * full[b][e]) {
        const auto& nodes = mesh.boundary_edges()[e].nodes;
        length += (traced.nodes[b][nodes[1]] - traced.nodes[b][nodes[0]]).norm();
      }
  }
  return length;
}

/// A plane of symmetry, seen as a mirror.
struct Mirror {
  Point at, normal;
};

/// The planes of symmetry of all bodies, each once; the axis is none.
std::vector<Mirror> mirrors_of(const HeatSystem& system, const TracedViews& traced) {
  constexpr double same = 1e-3;  // of a patch
  std::vector<Mirror> mirrors;
  for (const OpenEdge& at : traced.edges) {
    const core::Mesh& mesh = *system.problem->bodies[at.body].mesh;
    const core::BoundaryEdge& edge = mesh.boundary_edges()[at.edge];
    if (mesh.boundaries()[edge.boundary_id].kind != core::BoundaryKind::symmetry) continue;
    const Point x = traced.nodes[at.body][edge.nodes[0]];
    const Point along = (traced.nodes[at.body][edge.nodes[1]] - x).normalized(), normal(-along[1], along[0]);
    const bool on_axis =
        system.problem->geometry == Geometry::axisymmetric && std::abs(normal[0]) > std::abs(normal[1]);
    const auto is_same = [&](const Mirror& other) {
      return std::abs(normal.dot(other.normal)) > 1 - same &&
             std::abs(other.normal.dot(x - other.at)) < same * traced.patch_length;
    };
    if (!on_axis && std::none_of(mirrors.begin(), mirrors.end(), is_same)) mirrors.push_back({x, normal});
  }
  return mirrors;
}

/// The edges as the air sees them, also behind the planes of symmetry.
std::vector<ViewEdge> view_edges(const HeatSystem& system, const TracedViews& traced) {
  std::vector<ViewEdge> views;
  for (const OpenEdge& at : traced.edges) {
    const core::Mesh& mesh = *system.problem->bodies[at.body].mesh;
    const core::BoundaryEdge& edge = mesh.boundary_edges()[at.edge];
    const auto& x = traced.nodes[at.body];
    if (mesh.boundaries()[edge.boundary_id].kind == core::BoundaryKind::symmetry) continue;
    views.push_back({{x[edge.nodes[1]], x[edge.nodes[0]], x[edge.nodes[2]]},
                     at.patch,
                     at.patch < 0 ? 0 : std::max(0.0, traced.edge_open[at.body][at.edge])});
  }
  for (const Mirror& mirror : mirrors_of(system, traced)) {
    const auto mirrored = [&](const Point& x) -> Point {
      return x - 2 * mirror.normal.dot(x - mirror.at) * mirror.normal;
    };
    for (std::size_t i = 0, count = views.size(); i < count; ++i) {
      const SectionEdge& x = views[i].points;
      views.push_back({{mirrored(x[1]), mirrored(x[0]), mirrored(x[2])}, views[i].patch, 0});
    }
  }
  return views;
}

/// A sentence with the place where too much of what the open surfaces send is lost; empty where it is not.
std::string why_not_closed(const HeatSystem& system, const TracedViews& traced) {
  const auto middle_node = [&](const OpenEdge& at) {
    return system.problem->bodies[at.body].mesh->boundary_edges()[at.edge].nodes[2];
  };
  Eigen::ArrayXd sent = Eigen::ArrayXd::Zero(traced.views.lost.size());
  for (const OpenEdge& at : traced.edges)
    if (at.patch >= 0) sent[at.patch] += traced.edge_open[at.body][at.edge];
  if (sent.size() == 0 || !(traced.views.lost.sum() > most_lost * sent.sum())) return "";
  Eigen::Index worst;
  traced.views.lost.maxCoeff(&worst);
  Point place = Point::Zero();
  double weight = 0;
  for (const OpenEdge& at : traced.edges) {
    if (at.patch != worst) continue;
    const double area = traced.edge_open[at.body][at.edge];
    place += area * traced.nodes[at.body][middle_node(at)];
    weight += area;
  }
  place *= 1e3 / weight;
  return fmt::format(
      "enclosure: the views of the open surfaces cannot be closed: {:.2g} % of what they send ends behind a surface, "
      "most of it from near ({:.4g}, {:.4g}) mm, allowed are {:g} %; an outline in sight of that place is open, "
      "crosses itself or runs the wrong way round",
      100 * traced.views.lost.sum() / sent.sum(), place[0], place[1], 100 * most_lost);
}

/// Takes the patches out that see no other and not themselves.
void drop_alone(TracedViews& traced) {
  const Eigen::ArrayXd seen = traced.views.between.rowwise().sum().array();
  std::vector<Index> number(seen.size(), -1), kept;
  for (Eigen::Index p = 0; p < seen.size(); ++p)
    if (seen[p] > 0) {
      number[p] = static_cast<Index>(kept.size());
      kept.push_back(static_cast<Index>(p));
    }
  for (OpenEdge& edge : traced.edges)
    if (edge.patch >= 0) edge.patch = number[edge.patch];
  traced.views.between = traced.views.between(kept, kept).eval();
  traced.views.open = traced.views.open(kept).eval();
  traced.views.lost = traced.views.lost(kept).eval();
}

void set_areas(TracedViews& traced, const EdgeAreas& open, const EdgeAreas& full) {
  traced.area = traced.full = Eigen::ArrayXd::Zero(traced.views.open.size());
  traced.unseen = 0;
  for (const OpenEdge& at : traced.edges)
    if (at.patch >= 0) {
      traced.area[at.patch] += open[at.body][at.edge];
      traced.full[at.patch] += full[at.body][at.edge];
    } else {
      traced.unseen += open[at.body][at.edge];
    }
}

std::vector<std::vector<Point>> all_placed_nodes(const HeatSystem& system) {
  std::vector<std::vector<Point>> nodes;
  for (const BodyView& body : system.problem->bodies) nodes.push_back(placed_nodes(body));
  return nodes;
}

/// Traces the views with the nodes of the bodies at given places and given areas of their edges.
std::shared_ptr<const TracedViews> trace(const HeatSystem& system, std::vector<std::vector<Point>> nodes,
                                         EdgeAreas open, EdgeAreas full) {
  auto traced = std::make_shared<TracedViews>();
  traced->nodes = std::move(nodes);
  traced->edge_open = std::move(open);
  traced->edge_full = std::move(full);
  for (const BodyView& body : system.problem->bodies) traced->cells.push_back(body.mesh->cells());
  const LightResolution& resolution = system.problem->light_resolution;
  traced->patch_length = open_length(system, *traced) / resolution.patches();
  Index patches;
  traced->edges = divide(system, *traced, patches);
  traced->views = trace_views(view_edges(system, *traced), system.problem->geometry, patches, resolution.view_rays(),
                              resolution.part);
  traced->failure = why_not_closed(system, *traced);
  if (patches > 0) drop_alone(*traced);
  set_areas(*traced, traced->edge_open, traced->edge_full);
  for (const auto& body : traced->edge_full)
    traced->patch_area += std::accumulate(body.begin(), body.end(), 0.0) / resolution.patches();
  return traced;
}

/// Cuts numbers of all bodies into those of each, with so many as `like` has.
template <typename T, typename Like>
std::vector<std::vector<T>> by_body(const std::vector<T>& all, const Like& like) {
  std::vector<std::vector<T>> parts;
  auto at = all.begin();
  for (const auto& body : like) {
    const auto end = at + static_cast<std::ptrdiff_t>(body.size());
    parts.emplace_back(at, end);
    at = end;
  }
  return parts;
}

/// Goes back to the views that were traced at given places.
void recall(KeptTraces<TracedViews>& kept, const HeatSystem& system, const EdgeAreas& areas, const TracedPlaces& at) {
  if (at.views.empty()) {
    kept = {};
    return;
  }
  const auto nodes = by_body(at.views, all_placed_nodes(system));
  const EdgeAreas open = by_body(at.open_area, areas), full = by_body(at.area, areas);
  kept.recall(
      [&](const TracedViews& traced) {
        return traced.nodes == nodes && traced.edge_open == open && traced.edge_full == full;
      },
      [&] { return trace(system, nodes, open, full); });
}

bool is_near(const TracedViews& traced, const HeatSystem& system, const EdgeAreas& open, const EdgeAreas& full) {
  const auto& bodies = system.problem->bodies;
  if (traced.cells.size() != bodies.size()) return false;
  const double far = moved_far * traced.patch_length;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (traced.cells[b] != bodies[b].mesh->cells()) return false;
    const std::vector<Point> nodes = placed_nodes(bodies[b]);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!((nodes[i] - traced.nodes[b][i]).squaredNorm() < far * far)) return false;
  }
  TracedViews now;
  now.edges = traced.edges;
  now.views.open = traced.views.open;
  set_areas(now, open, full);
  return now.unseen <= traced.unseen + traced.patch_area;
}

}  // namespace

std::shared_ptr<const TracedViews> views_that_serve(const HeatSystem& system, const EdgeAreas& open,
                                                    const EdgeAreas& full, KeptTraces<TracedViews>& kept) {
  if (system.problem->traced) recall(kept, system, open, *system.problem->traced);
  if (!kept.last || !is_near(*kept.last, system, open, full))
    kept.add(trace(system, all_placed_nodes(system), open, full));
  return kept.last;
}

}  // namespace parison::thermal
