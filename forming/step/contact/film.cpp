// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "remesh/surface/film.hpp"
#include "remesh/surface/wall_thickness.hpp"

namespace parison::forming {

namespace {

/// Relative tolerance on the smallest film thickness: a film of just that thickness is allowed.
constexpr double film_tolerance = 1e-3;

struct Films {
  remesh::Wall wall;
  Eigen::VectorXd thickness;  ///< per node, m; infinite where the glass is no film
};

/// The films, and the wall thickness where it is at most `reach`, m, at nodes that `only`, where it is given, names.
Films find_films(const GlassState& glass, double reach, const std::vector<bool>& only = {}) {
  Films films{remesh::surface_wall(glass.mesh, reach, only), {}};
  films.thickness = remesh::film_between_tools(glass.mesh, films.wall, glass.contact_tool);
  return films;
}

bool touches_nothing(const State& state) {
  return std::all_of(state.glass.contact_tool.begin(), state.glass.contact_tool.end(),
                     [](Index tool) { return tool < 0; });
}

/// The tool on the other side of a film's node, -1 for its mirror image.
Index opposite_tool(const Films& films, const State& state, Index node) {
  for (const Index n : state.glass.mesh.boundary_edges()[films.wall.far_edge[node]].nodes)
    if (const Index tool = state.glass.contact_tool[n]; tool >= 0) return tool;
  return -1;
}

double gap_to(const Scene& scene, const State& state, Index node, Index tool) {
  const Body& body = scene.tools[tool];
  const Point local = state.glass.mesh.nodes[node] - state.tools[tool].offset * core::axis_direction();
  return contact::signed_gap(body.profile, contact_boundaries(body), local);
}

/// The thinnest film below `limit`, m, and its node. The distance between the tools is what counts, because near its
/// rim a film touches them only along part of its edges, whose middles may keep off the tool.
std::pair<double, Index> thinnest_film(const Scene& scene, const State& state, const Films& films, double limit) {
  std::pair<double, Index> minimum{std::numeric_limits<double>::infinity(), -1};
  for (Index n = 0; n < films.thickness.size(); ++n) {
    double thickness = films.thickness[n];
    if (!(thickness < std::min(minimum.first, limit))) continue;
    if (const Index there = opposite_tool(films, state, n); there >= 0)
      thickness = std::max(thickness, gap_to(scene, state, n, there) +
                                          std::max(0.0, gap_to(scene, state, n, state.glass.contact_tool[n])));
    if (thickness < minimum.first) minimum = {thickness, n};
  }
  return minimum;
}

bool is_driven(const Scene& scene, const State& state, Index tool) {
  const auto& tools = scene.stages[state.stage].tools;
  return std::any_of(tools.begin(), tools.end(),
                     [&](const StageTool& place) { return place.tool == tool && place.is_driven(); });
}

/// Whether tools with a prescribed motion approach each other at a film's node, so that the film cannot stop them.
bool is_crushed(const Scene& scene, const State& state, const Films& films, Index node) {
  const Index here = state.glass.contact_tool[node], there = opposite_tool(films, state, node);
  const double outward = films.wall.normal[node].dot(core::axis_direction());
  const double speed = state.tools[here].velocity;
  const double closing = outward * ((there < 0 ? -speed : state.tools[there].velocity) - speed);
  const double standing = core::tolerance::standing_speed * core::size(scene.glass.profile);
  return closing > standing && !is_driven(scene, state, here) && (there < 0 || !is_driven(scene, state, there));
}

}  // namespace

std::string film_failure(const Scene& scene, const State& state) {
  if (touches_nothing(state)) return "";
  const FilmLimit& limit = scene.glass.film;
  std::vector<bool> in_contact;  // a film is between tools
  for (const Index tool : state.glass.contact_tool) in_contact.push_back(tool >= 0);
  const Films films = find_films(state.glass, limit.min_thickness, in_contact);
  const double allowed = (1 - film_tolerance) * limit.min_thickness;
  const auto [min_thickness, node] = thinnest_film(scene, state, films, allowed);
  if (!(min_thickness < allowed)) return "";
  const bool freezes = limit.then == FilmLimit::Then::freeze;
  if (freezes && !is_crushed(scene, state, films, node)) return "";
  const Index there = opposite_tool(films, state, node);
  const Point middle = state.glass.mesh.nodes[node] - 0.5 * min_thickness * films.wall.normal[node];
  return fmt::format(
      "the glass between {} and {} is {:.4g} mm thick near ({:.2f}, {:.2f}) mm, {} {:.4g} mm, film.min_thickness of "
      "the glass{}",
      scene.tools[state.glass.contact_tool[node]].name, there < 0 ? "its mirror image" : scene.tools[there].name,
      1e3 * min_thickness, 1e3 * middle[0], 1e3 * middle[1],
      freezes ? "it is frozen below" : "allowed are films of at least", 1e3 * limit.min_thickness,
      freezes ? ", but a prescribed motion closes the tools further"
              : "; where so thin a film is meant, film.then = \"freeze\" lets it flow no more and the run go on, and a "
                "smaller film.min_thickness follows it farther");
}

std::vector<bool> frozen_cells(const Scene& scene, const State& state) {
  const FilmLimit& limit = scene.glass.film;
  if (limit.then != FilmLimit::Then::freeze || touches_nothing(state)) return {};
  const core::Mesh& mesh = state.glass.mesh;
  const Films films = find_films(state.glass, std::numeric_limits<double>::infinity());
  if (films.thickness.minCoeff() >= limit.min_thickness) return {};
  Eigen::VectorXd nearest =
      films.wall.thickness;  // 1 on films, 0 on other walls; inside, the value of the nearest surface node
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (std::isfinite(nearest[n])) nearest[n] = films.thickness[n] < limit.min_thickness ? 1 : 0;
  remesh::spread_inward(mesh, nearest);
  std::vector<bool> frozen(mesh.cells().size());
  for (std::size_t c = 0; c < frozen.size(); ++c)
    frozen[c] = std::all_of(mesh.cells()[c].begin(), mesh.cells()[c].end(), [&](Index n) { return nearest[n] == 1; });
  return frozen;
}

}  // namespace parison::forming
