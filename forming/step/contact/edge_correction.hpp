#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Moves the middle nodes of edges that enter a tool of `state` between their ends out of it, as a constraint of the
/// flow cannot where glass slides around a corner: an edge of length L over a corner that turns by t cuts it by L t/10
/// within the way of half an edge. An edge may stay as deep as its ends are, or as a node at the tool. Edges
/// with no node that touches the tool stay as they are (`touched`: the tool of each node, -1 for none); one whose cell
/// would be inverted is moved as far as it can be. Whether any was moved.
bool move_edges_out(const Scene& scene, const State& state, const std::vector<Index>& touched, core::Mesh& mesh);

/// The same at the end of a step; the volume stays.
void correct_edges(const Scene& scene, State& state);

}  // namespace parison::forming
