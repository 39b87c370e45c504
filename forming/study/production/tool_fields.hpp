#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The nodal temperatures of all tools, one after the other, as one vector, K.
Eigen::VectorXd tool_temperatures(const State& state);
void set_tool_temperatures(const Eigen::VectorXd& temperatures, State& state);

/// The scene with its tools at these temperatures at the start; the meshes are those of the state, which stay the
/// first meshes of the scene.
Scene with_tools_at(const Scene& scene, const State& state, const Eigen::VectorXd& temperatures);

/// The scene, read again, with its tools as in a folder of results; its first meshes stay the same.
Scene with_tools_of(const Scene& scene, const std::string& folder);

/// The largest of a vector of changes of all tools' temperatures on their contact boundaries, K, without sign, and of
/// each tool.
std::vector<double> surface_changes(const State& state, const Eigen::VectorXd& changes);
double surface_change(const State& state, const Eigen::VectorXd& changes);

/// A state with the tools alone: what idle_tools needs.
State tools_of(const State& state);

}  // namespace parison::forming
