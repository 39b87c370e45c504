// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/enclosure.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

constexpr int patch_count = 64;  ///< as many have the length of the surface
constexpr int rays_of_patch = 256;
constexpr double moved_far = 0.3;   ///< of the length of a patch, before views are traced anew
constexpr double opened_far = 0.3;  ///< the same of the area of a patch that a tool covers or uncovers
constexpr double covered = 1e-3;    ///< share of an edge's area below which it is closed

using Areas = std::vector<std::vector<double>>;  ///< by body and boundary edge, m2

/// Whether a boundary takes part: it sees the surroundings, and its temperature is not prescribed.
bool takes_part(const BodyView& body, Index boundary) {
  return !body.light.surroundings.empty() && body.light.surroundings[boundary] &&
         (body.prescribed.empty() || !body.prescribed[boundary]);
}

std::vector<Index> edges_of_mid_nodes(const core::Mesh& mesh) {
  std::vector<Index> edge(mesh.nodes.size(), -1);
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e)
    edge[mesh.boundary_edges()[e].nodes[2]] = static_cast<Index>(e);
  return edge;
}

/// Calls what(body, edge, unknowns, shape, area) for each point of the surfaces and, with the area negative, of the
/// interface.
template <typename What>
void for_each_point(const HeatSystem& system, What&& what) {
  const Problem& problem = *system.problem;
  std::vector<std::vector<Index>> edge_of(problem.bodies.size());
  for (std::size_t b = 0; b < problem.bodies.size(); ++b) {
    const core::Mesh& mesh = *problem.bodies[b].mesh;
    edge_of[b] = edges_of_mid_nodes(mesh);
    for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
      const core::BoundaryEdge& edge = mesh.boundary_edges()[e];
      if (!takes_part(problem.bodies[b], edge.boundary_id)) continue;
      const auto unknowns = edge_unknowns(system, static_cast<Index>(b), edge.nodes);
      for (int q = 0; q < 3; ++q)
        what(static_cast<Index>(b), static_cast<Index>(e), unknowns, unknown_weights(edge_shapes()[q], problem.order),
             core::map_edge_point(mesh, edge.nodes, problem.geometry, core::edge_rule(3)[q]).area);
    }
  }
  for (std::size_t i = 0; i < problem.interface.size(); ++i) {
    const core::InterfacePoint& point = problem.interface[i];
    const double area = -system.interface.area[static_cast<Index>(i)];
    const auto side = [&](Index body, const std::array<Index, 3>& nodes, const std::array<double, 3>& shape) {
      const Index edge = edge_of[body][nodes[2]];
      if (takes_part(problem.bodies[body], problem.bodies[body].mesh->boundary_edges()[edge].boundary_id))
        what(body, edge, edge_unknowns(system, body, nodes), unknown_weights(shape, problem.order), area);
    };
    side(point.slave_body, point.slave_nodes, point.slave_shape);
    side(point.master_body, point.master_nodes, point.master_shape);
  }
}

/// Areas of the edges that take part: open, and in all.
std::pair<Areas, Areas> edge_areas(const HeatSystem& system) {
  Areas open, full;
  for (const BodyView& body : system.problem->bodies)
    open.emplace_back(body.mesh->boundary_edges().size(), 0.0), full.push_back(open.back());
  for_each_point(system, [&](Index body, Index edge, const auto&, const auto&, double area) {
    open[body][edge] += area;
    full[body][edge] += std::max(0.0, area);
  });
  return {std::move(open), std::move(full)};
}

std::vector<Point> placed_nodes(const BodyView& body) {
  std::vector<Point> nodes = body.mesh->nodes;
  for (Point& x : nodes) x += body.light.offset * core::axis_direction();
  return nodes;
}

/// Divides the open surface into patches of one boundary each; the edges of all bodies, which may hide each other.
std::vector<OpenEdge> divide(const HeatSystem& system, const Areas& open, const Areas& full, double length,
                             Index& patches) {
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
      const double own = (body.mesh->nodes[edge.nodes[1]] - body.mesh->nodes[edge.nodes[0]]).norm();
      if (last != edge.boundary_id || so_far + 0.5 * own > length) ++patches, so_far = 0;
      so_far += own;
      last = edge.boundary_id;
      added.patch = patches - 1;
    }
  }
  return edges;
}

double open_length(const HeatSystem& system, const Areas& open, const Areas& full) {
  double length = 0;
  for (std::size_t b = 0; b < open.size(); ++b) {
    const core::Mesh& mesh = *system.problem->bodies[b].mesh;
    for (std::size_t e = 0; e < open[b].size(); ++e)
      if (full[b][e] > 0 && open[b][e] > covered * full[b][e]) {
        const auto& nodes = mesh.boundary_edges()[e].nodes;
        length += (mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).norm();
      }
  }
  return length;
}

/// The edges as the air sees them; of a planar section with a plane of symmetry also behind that mirror.
std::vector<ViewEdge> view_edges(const HeatSystem& system, const TracedViews& traced, const Areas& open) {
  std::vector<ViewEdge> views;
  std::optional<double> mirror;
  for (const OpenEdge& at : traced.edges) {
    const core::Mesh& mesh = *system.problem->bodies[at.body].mesh;
    const core::BoundaryEdge& edge = mesh.boundary_edges()[at.edge];
    const auto& x = traced.nodes[at.body];
    const bool symmetric = mesh.boundaries()[edge.boundary_id].kind == core::BoundaryKind::symmetry;
    if (symmetric && system.problem->geometry == Geometry::planar) mirror = x[edge.nodes[0]][0];
    if (symmetric) continue;
    views.push_back({{x[edge.nodes[1]], x[edge.nodes[0]], x[edge.nodes[2]]},
                     at.patch,
                     at.patch < 0 ? 0 : std::max(0.0, open[at.body][at.edge])});
  }
  if (!mirror) return views;
  const auto mirrored = [&](const Point& p) { return Point(2 * *mirror - p[0], p[1]); };
  for (std::size_t i = 0, count = views.size(); i < count; ++i) {
    const SectionEdge& x = views[i].points;
    views.push_back({{mirrored(x[1]), mirrored(x[0]), mirrored(x[2])}, views[i].patch, 0});
  }
  return views;
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
}

void set_areas(TracedViews& traced, const Areas& open, const Areas& full) {
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

std::shared_ptr<const TracedViews> trace(const HeatSystem& system, const Areas& open, const Areas& full) {
  auto traced = std::make_shared<TracedViews>();
  for (const BodyView& body : system.problem->bodies) {
    traced->nodes.push_back(placed_nodes(body));
    traced->cells.push_back(body.mesh->cells());
  }
  traced->patch_length = open_length(system, open, full) / patch_count;
  Index patches;
  traced->edges = divide(system, open, full, traced->patch_length, patches);
  traced->views = trace_views(view_edges(system, *traced, open), system.problem->geometry, patches, rays_of_patch);
  if (patches > 0) drop_alone(*traced);
  set_areas(*traced, open, full);
  for (const auto& body : full) traced->patch_area += std::accumulate(body.begin(), body.end(), 0.0) / patch_count;
  return traced;
}

bool is_near(const TracedViews& traced, const HeatSystem& system, const Areas& open, const Areas& full) {
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
  return now.unseen <= traced.unseen + opened_far * traced.patch_area &&
         !((now.area - traced.area).abs() > opened_far * now.full).any();
}

void add_points(Enclosure& enclosure, const HeatSystem& system) {
  std::vector<std::vector<Index>> patch_of;
  patch_of.reserve(system.problem->bodies.size());
  for (const BodyView& body : system.problem->bodies) patch_of.emplace_back(body.mesh->boundary_edges().size(), -1);
  for (const OpenEdge& at : enclosure.traced->edges) patch_of[at.body][at.edge] = at.patch;
  for_each_point(system, [&](Index body, Index edge, const auto& unknowns, const auto& shape, double area) {
    if (patch_of[body][edge] >= 0) enclosure.points.push_back({unknowns, shape, area, patch_of[body][edge], edge});
  });
}

void add_patches(Enclosure& enclosure, const HeatSystem& system) {
  const TracedViews& traced = *enclosure.traced;
  enclosure.patches.resize(traced.views.open.size());
  for (const OpenEdge& at : traced.edges) {
    if (at.patch < 0) continue;
    const BodyView& body = system.problem->bodies[at.body];
    const Index boundary = body.mesh->boundary_edges()[at.edge].boundary_id;
    enclosure.patches[at.patch] = {at.body, boundary, body.light.emissivity, &*body.light.surroundings[boundary]};
  }
}

/// The traced views, closed for the areas that are open now. What is left of a patch that has been covered since takes
/// no part.
Views present_views(const TracedViews& traced, Eigen::ArrayXd& area) {
  Views views = traced.views;
  for (Eigen::Index p = 0; p < area.size(); ++p) {
    if (area[p] > covered * traced.full[p]) continue;
    area[p] = covered * traced.full[p];
    views.between.row(p).setZero(), views.between.col(p).setZero();
    views.open[p] = area[p];
  }
  return closed(std::move(views), area);
}

}  // namespace

std::shared_ptr<const Enclosure> make_enclosure(const HeatSystem& system, std::shared_ptr<const TracedViews>& traced) {
  const auto [open, full] = edge_areas(system);
  if (!traced || !is_near(*traced, system, open, full)) traced = trace(system, open, full);
  auto enclosure = std::make_shared<Enclosure>();
  enclosure->traced = traced;
  add_patches(*enclosure, system);
  add_points(*enclosure, system);
  const auto count = static_cast<Eigen::Index>(enclosure->patches.size());
  enclosure->area.setZero(count), enclosure->emissivity.resize(count);
  for (const EnclosurePoint& point : enclosure->points) enclosure->area[point.patch] += point.area;
  for (Eigen::Index p = 0; p < count; ++p) enclosure->emissivity[p] = enclosure->patches[p].emissivity;
  enclosure->views = present_views(*traced, enclosure->area);
  if (count == 0) return enclosure;
  Eigen::MatrixXd radiosity = -enclosure->views.between * (1 - enclosure->emissivity).matrix().asDiagonal();
  radiosity.diagonal().array() += enclosure->area;
  enclosure->grey.compute(radiosity);
  return enclosure;
}

}  // namespace parison::thermal
