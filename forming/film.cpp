// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/thickness.hpp"
#include "forming/initial_state.hpp"
#include "remesh/film.hpp"

namespace parison::forming {

namespace {

/// A frozen film that is crushed below this share of the thinnest ends the run: the motion of its tools is given.
constexpr double crushed = 0.5;

struct Films {
  core::Wall wall;
  Eigen::VectorXd thickness;  ///< per node, m; infinite where the glass is no film
};

Films find_films(const Scene& scene, const State& state) {
  const core::Mesh& mesh = state.bodies[0].mesh;
  const auto symmetry = symmetry_pieces(scene.glass, mesh);
  std::vector<bool> contact(mesh.nodes.size());
  for (std::size_t n = 0; n < contact.size(); ++n) contact[n] = state.contact.tool[n] >= 0;
  Films films{core::surface_wall(mesh, symmetry), {}};
  films.thickness = remesh::film_thickness(mesh, films.wall, symmetry, contact);
  return films;
}

bool touches_nothing(const State& state) {
  return std::all_of(state.contact.tool.begin(), state.contact.tool.end(), [](Index tool) { return tool < 0; });
}

/// "blank and plunger": the tools on both sides of a film.
std::string sides(const Scene& scene, const State& state, Index node, const core::BoundaryEdge& other) {
  const std::string& name = scene.tools[state.contact.tool[node]].name;
  for (const Index n : other.nodes)
    if (const Index tool = state.contact.tool[n]; tool >= 0) return name + " and " + scene.tools[tool].name;
  return name + " and its mirror image";
}

}  // namespace

std::string film_obstacle(const Scene& scene, const State& state) {
  if (touches_nothing(state)) return "";
  const FilmLimit& limit = scene.glass.film;
  const bool frozen = limit.then == FilmLimit::Then::freeze;
  const Films films = find_films(scene, state);
  Index node;
  const double thinnest = films.thickness.minCoeff(&node);
  if (thinnest >= (frozen ? crushed : 1) * limit.thinnest) return "";
  const core::Mesh& mesh = state.bodies[0].mesh;
  const Point middle = mesh.nodes[node] - 0.5 * thinnest * films.wall.normal[node];
  return fmt::format("the glass between {} is {:.3g} mm thick near ({:.2f}, {:.2f}) mm, {}",
                     sides(scene, state, node, mesh.boundary[films.wall.far_edge[node]]), 1e3 * thinnest, 1e3 * middle[0],
                     1e3 * middle[1],
                     frozen ? fmt::format("frozen at {:.3g} mm and crushed by tools that do not give way", 1e3 * limit.thinnest)
                            : fmt::format("the film may be no thinner than {:.3g} mm", 1e3 * limit.thinnest));
}

std::vector<bool> frozen_cells(const Scene& scene, const State& state) {
  const FilmLimit& limit = scene.glass.film;
  if (limit.then != FilmLimit::Then::freeze || touches_nothing(state)) return {};
  const core::Mesh& mesh = state.bodies[0].mesh;
  const Films films = find_films(scene, state);
  if (films.thickness.minCoeff() >= limit.thinnest) return {};
  Eigen::VectorXd nearest = films.wall.thickness;  // inside, that of the nearest surface node: a film there or not
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (std::isfinite(nearest[n])) nearest[n] = films.thickness[n] < limit.thinnest ? 1 : 0;
  core::spread_inward(mesh, nearest);
  std::vector<bool> frozen(mesh.cells.size());
  for (std::size_t c = 0; c < frozen.size(); ++c)
    frozen[c] = std::all_of(mesh.cells[c].begin(), mesh.cells[c].end(), [&](Index n) { return nearest[n] == 1; });
  return frozen;
}

}  // namespace parison::forming
