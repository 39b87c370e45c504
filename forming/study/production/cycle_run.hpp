#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/tool_surface.hpp"
#include "forming/study/production/machine_cycle.hpp"

namespace parison::forming {

/// The changes of a case that settled production does not depend on: the temperatures at which its tools start, since
/// each container brings them nearer to those at which a tool gives off what it receives.
std::vector<std::string> lost_changes(const Scene& scene, const std::vector<CaseDifference>& settings);

/// What changes the temperatures of a tool in settled production, as the end of a sentence.
std::string what_settled_tools_depend_on(const std::string& key);

/// The tools at one moment of a machine cycle. A tool that still serves the container before is as it is then, with
/// that one.
struct CycleSample {
  double time;        ///< s since the start of the container
  std::string stage;  ///< "idle" after the container has left
  std::vector<ToolTemperatures> tools;
  std::vector<double> probes;  ///< of the tools, K, in the order of the scene; NaN for those of the glass
};

/// Heat of a tool over its cycle, J.
struct CycleHeat {
  double received;              ///< from the glass
  std::vector<double> through;  ///< out through each boundary
};

/// A machine cycle as it went: one container, and the tools until the next one starts.
struct CycleRun {
  std::string failure;  ///< why it has no end; empty where it has
  bool stopped = false;
  RunOutcome forming;
  Eigen::VectorXd start, end;  ///< tool_temperatures at both ends of the cycle of each tool, K
  std::vector<double> met;     ///< mean temperature of the glass when the use of each tool begins, K
  std::vector<double> used;    ///< when the use of each tool ends, s since the start of its cycle; 0 for one without
  Eigen::VectorXd left;        ///< tool_temperatures at that end, K
  std::vector<CycleHeat> heat;
  std::vector<CycleSample> samples;
};

/// Forms one container in the machine cycle. The results of the forming go into a new folder unless that is empty. From
/// the end of the last stage on the tools exchange heat with the air and their cooling as that stage has them.
CycleRun run_cycle(const Scene& scene, const MachineCycle& cycle, const std::string& directory,
                   const StopRequest& stop);

}  // namespace parison::forming
