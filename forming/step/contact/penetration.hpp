#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// A glass node inside an active tool.
struct Penetration {
  Index node, tool;
  double depth;  ///< from the contact boundaries, m
};
/// All penetrations after a time `ahead`, s, with the present velocities.
std::vector<Penetration> penetrations(const Scene& scene, const State& state, double ahead);

/// Depth of the deepest glass node inside an active tool, m, or `known` where that is more; with what earlier steps
/// had as `known` little is searched.
double max_penetration(const Scene& scene, const State& state, double known = 0);

/// Places on an edge (first, last, middle node, m, in the tool's frame) where penetration is looked for: its eighths,
/// and where joints of the tool's outline lie beside it, since at a corner the tool may be deeper in the edge than at
/// any place chosen without it.
std::vector<double> places_on(const std::array<Point, 3>& edge, const core::Profile& outline);

/// Depth of the deepest of nine points on each edge of the glass that may touch, and of its places beside joints of a
/// tool's outline, in an active tool, m, or `known`: between nodes, a corner or a small radius of a tool can be deeper.
double max_edge_penetration(const Scene& scene, const State& state, double known = 0);

/// Depth of the deepest edge of `after` in a tool, m, where it is deeper than the correction of edges leaves one that
/// it can move and deeper than any of `before` by more than a step may move a node into a tool; else 0.
double edge_depth_gained(const Scene& scene, const State& before, const State& after);

/// Raises the depths of nodes and edges in the totals of a state, in m and in mean walls of the glass as it is then.
void note_penetration(const Scene& scene, State& state);

}  // namespace parison::forming
