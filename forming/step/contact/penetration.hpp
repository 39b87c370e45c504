#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
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

/// How deep glass is in an active tool; no tool where nothing is deeper than what was known before.
struct Depth {
  double depth;  ///< m
  Index tool = -1;
  Point place = Point::Zero();  ///< of the glass there, m
};

/// The deepest glass node inside an active tool, or `known`, m, where that is more: the distance to the face of the
/// tool that is closest, with or without contact. With what earlier steps had as `known` little is searched.
Depth deepest_node(const Scene& scene, const State& state, double known = 0);

/// The places on an edge, from 0 at its first node to 1 at its last, where penetration is looked for on every edge.
inline constexpr std::array<double, 9> edge_eighths{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1};

/// Places on an edge (first, last, middle node, m, in the tool's frame) where penetration is looked for: its eighths
/// first, and where joints of the tool's outline lie beside it, since at a corner the tool may be deeper in the edge
/// than at any place chosen without it.
std::vector<double> places_on(const std::array<Point, 3>& edge, const core::Profile& outline);

/// The deepest of nine points on each edge of the glass that may touch, and of its places beside joints of a tool's
/// outline, in an active tool, or `known`, m: between nodes, a corner or a small radius of a tool can be deeper.
Depth deepest_edge(const Scene& scene, const State& state, double known = 0);

/// Depth of the deepest edge of `after` in a tool, behind its contact boundaries, m, where it is deeper than the
/// correction of edges leaves one that it can move and deeper than any of `before` by more than a step may move a node
/// into a tool; else 0.
double edge_depth_gained(const Scene& scene, const State& before, const State& after);

/// ", where contact boundary under of ring ends at its boundary hole, which has no contact" of a cell of the glass
/// with a node at such an end in an active tool; else empty.
std::string end_of_contact(const Scene& scene, const State& state, Index cell);

}  // namespace parison::forming
