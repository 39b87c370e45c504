#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/problem.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The candidates that were closed in the last solve, or, where a new mesh or stage knows only the tool of each node,
/// its nearest one; and those that `guess` would carry through.
std::vector<bool> likely_contacts(const State& state, const ActiveContacts& active, const flow::Problem& problem,
                                  const Eigen::VectorXd& guess);

/// Adds the bounds that point another way than the node's own, beside those.
void keep_bounds(const std::vector<flow::ContactCandidate>& bounds, std::vector<flow::ContactCandidate>& candidates);

/// Both sides of the corners of tools in which the last step left nodes: a hollow so flat that it counts as smooth
/// shows a node only the nearer one.
std::vector<flow::ContactCandidate> corner_bounds(const Scene& scene, const State& state);

}  // namespace parison::forming
