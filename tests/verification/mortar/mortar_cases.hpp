#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "contact/mortar/mortar.hpp"
#include "thermal/bodies.hpp"
#include "thermal/time/stage_solver.hpp"

namespace parison::mortar_test {

using core::Geometry;
using core::Index;
using core::Point;
using thermal::test::divide;
using thermal::test::Side;

using Scalar = std::function<double(const Point&)>;
using Map = std::function<Point(const Point&)>;

/// Rectangle on a grid, carried elsewhere by a map; mid-side nodes are mapped too.
inline core::Mesh mapped(const std::vector<double>& x, const std::vector<double>& y, const Map& map) {
  core::Mesh mesh = thermal::test::rectangle(x, y);
  for (Point& node : mesh.nodes) node = map(node);
  return mesh;
}
/// With all edges straight.
inline core::Mesh faceted(core::Mesh mesh) {
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) mesh.nodes[cell[3 + i]] = 0.5 * (mesh.nodes[cell[i]] + mesh.nodes[cell[(i + 1) % 3]]);
  return mesh;
}

/// Two bodies: the bottom side of the first lies on the top side of the second.
struct Pair {
  Geometry geometry;
  std::array<core::Mesh, 2> mesh;
  std::array<thermal::Material, 2> material;
  thermal::Problem problem;
  std::array<std::vector<double>, 2> source;
  std::vector<Eigen::VectorXd> load;  ///< W into the nodes, besides the problem's own

  Pair(Geometry given, core::Mesh first, core::Mesh second, const std::array<double, 2>& conductivity)
      : geometry(given), mesh{std::move(first), std::move(second)} {
    for (const int b : {0, 1}) {
      material[b] = {1, core::constant(1), core::constant(conductivity[b]), {}};
      load.push_back(Eigen::VectorXd::Zero(mesh[b].node_count()));
    }
    problem.geometry = geometry;
    problem.bodies = {thermal::test::body(mesh[0], material[0]), thermal::test::body(mesh[1], material[1])};
  }
  Pair(const Pair&) = delete;

  contact::Surface surface(Index body) const {
    std::vector<bool> touches(4, false);
    touches[body == 0 ? Side::bottom : Side::top] = true;
    return contact::make_surface(body, mesh[body], touches, Point::Zero());
  }
  /// Builds the interface with either body as the slave; `gap` and `pressure` as functions of position.
  void join(Index slave, double width, const Scalar& gap, const Scalar& pressure) {
    problem.interface = contact::build_interface(
        surface(slave), thermal::test::sample(mesh[slave], pressure),
        {contact::Master{surface(1 - slave), thermal::test::sample(mesh[slave], gap), width, 0}}, geometry);
  }
  void add_source(Index body, const Scalar& f) {
    for (Index c = 0; c < mesh[body].cell_count(); ++c)
      for (const auto& at : core::triangle_rule(4)) {
        const auto point = core::map_cell_point(mesh[body], c, geometry, at);
        source[body].push_back(point.volume * f(point.position));
      }
    problem.bodies[body].source = &source[body];
  }
  /// Flux into a body, W/m2 at a point with the outward normal there, over the edges of chosen boundaries.
  void add_flux(Index body, const std::vector<Index>& boundaries,
                const std::function<double(const Point&, const Point&)>& flux) {
    for (const auto& edge : mesh[body].boundary_edges())
      if (std::find(boundaries.begin(), boundaries.end(), edge.boundary_id) != boundaries.end())
        for (const auto& rule : core::edge_rule(5)) {
          const auto at = core::map_edge_point(mesh[body], edge.nodes, geometry, rule);
          const double heat = at.area * flux(at.position, at.normal);
          for (int i = 0; i < 3; ++i) load[body][edge.nodes[i]] += at.shape[i] * heat;
        }
  }
  std::vector<Index> free_sides(Index body) const {
    return {Side::right, body == 0 ? Side::top : Side::bottom, Side::left};
  }
};

/// Normal of the edge of an interface point's slave, straight, out of the slave.
inline Point facet_normal(const core::Mesh& slave, const core::InterfacePoint& point) {
  const Point along = (slave.nodes[point.slave_nodes[1]] - slave.nodes[point.slave_nodes[0]]).normalized();
  return {along[1], -along[0]};
}

struct Solved {
  std::vector<Eigen::VectorXd> temperature;
  thermal::Flows flows;
};
/// Solves content(T) - content(start) = step (power(T) + load), a step of backward Euler, as the program solves its
/// stages. With density and heat capacity 1 and a step of 1 it says -div(k grad T) + T = start + source; a step that is
/// long against the bodies' diffusion time gives the steady state.
inline Solved solve(const Pair& pair, const std::vector<Eigen::VectorXd>& start, double step, double tolerance = 1e-9) {
  const auto system = thermal::make_heat_system(pair.problem);
  thermal::StepMatrix matrix;
  prepare(matrix, system);
  Eigen::VectorXd guess = join(system, start);
  const Eigen::VectorXd target = thermal::evaluate(system, 0, guess).content + step * join(system, pair.load);
  impose_prescribed(system, 0, guess);
  thermal::StageSolution stage;
  for (int round = 0; round < 3; ++round) {  // each with a factor at the temperatures of the one before
    EXPECT_TRUE(factorise(matrix, system, 0, guess, step));
    const thermal::Response at_guess = thermal::evaluate(system, 0, guess);
    stage = solve_stage(system, matrix, {0, step, target}, {guess, at_guess.content, at_guess.power}, tolerance);
    guess = stage.temperature;
  }
  EXPECT_TRUE(stage.converged);
  return {split(system, guess), evaluate_flows(system, 0, guess)};
}

}  // namespace parison::mortar_test
