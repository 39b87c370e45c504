// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/process/glass_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/element.hpp"

namespace parison::forming {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void add_skin(const Scene& scene, const GlassState& glass, GlassShape& shape) {
  double sum = 0, area = 0, logarithm = 0, least = std::numeric_limits<double>::infinity();
  for (const core::BoundaryEdge& edge : glass.mesh.boundary_edges()) {
    if (glass.mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    for (const Index node : edge.nodes) least = std::min(least, glass.temperature[node]);
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const core::EdgePoint point = core::map_edge_point(glass.mesh, edge.nodes, scene.geometry, at);
      double temperature = 0;
      for (std::size_t i = 0; i < 3; ++i) temperature += point.shape[i] * glass.temperature[edge.nodes[i]];
      sum += point.area * temperature;
      area += point.area;
      if (scene.has_flow()) logarithm += point.area * std::log(scene.glass.flow->viscosity(temperature));
    }
  }
  shape.skin_mean = sum / area;
  shape.skin_min = least;
  if (scene.has_flow()) shape.skin_viscosity = std::exp(logarithm / area);
}

}  // namespace

GlassShape glass_shape(const Scene& scene, const State& state) {
  GlassShape shape{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), none, none, none};
  for (const Point& x : state.glass.mesh.nodes) {
    shape.low = std::min(shape.low, x[core::dim - 1]);
    shape.high = std::max(shape.high, x[core::dim - 1]);
  }
  if (scene.has_heat()) add_skin(scene, state.glass, shape);
  return shape;
}

int upwards(const Scene& scene, const State& state) {
  return scene.stages.at(state.stage).gravity > 0 ? -1 : 1;
}

double lowest_downwards(const Scene& scene, const State& state) {
  if (scene.stages.at(state.stage).gravity == 0) return none;
  double lowest = -std::numeric_limits<double>::infinity();
  for (const Point& x : state.glass.mesh.nodes) lowest = std::max(lowest, -upwards(scene, state) * x[core::dim - 1]);
  return lowest;
}

}  // namespace parison::forming
