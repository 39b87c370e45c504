#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/study/production/cycle_run.hpp"

namespace parison::forming {

/// Temperatures of the surface of a tool over a machine cycle, K.
struct SurfaceRange {
  double min = std::numeric_limits<double>::infinity(), mean = 0, max = 0;  ///< of its mean
  double hottest = 0;                                                       ///< point
};

SurfaceRange range_of(const std::vector<CycleSample>& samples, std::size_t tool);

/// Why no machine makes containers with tools that are so hot: a sentence for each tool to all of whose surface glass
/// sticks, by the limit of the case for a tool surface, or that is hotter at some place than the softening point of
/// the glass, 10^6.6 Pa.s (Littleton, 1927). Empty where production is possible.
std::vector<std::string> why_not_possible(const Scene& scene, const std::vector<CycleSample>& samples);

/// A sentence for each tool whose surface is colder than the 400 degC that blanks and moulds have at least in
/// production, in the mean over it and the cycle.
std::vector<std::string> too_cold(const Scene& scene, const std::vector<CycleSample>& samples);

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
