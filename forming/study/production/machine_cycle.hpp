#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// What swabs of the tools do to their temperatures. A swab takes a given heat from the contact surface, the same from
/// each place, just before the next cycle of the tool; the temperatures that it leaves are added to what the cycle
/// leaves, as heat conduction with constant properties allows.
struct SwabImprint {
  Eigen::VectorXd change;    ///< by one swab of each tool, K, as tool_temperatures
  Eigen::VectorXd share;     ///< of a swab in a cycle, by node: 1/Swab::every; 0 for a tool without
  std::vector<double> heat;  ///< of one swab, J, by tool
  std::string failure;       ///< why there is none; empty where there is

  bool exists() const { return share.size() > 0 && share.maxCoeff() > 0; }
  /// What the swabs take from the temperatures in a cycle, in the mean over many, K.
  Eigen::VectorXd mean() const { return change.cwiseProduct(share); }
};

SwabImprint swab_imprint(const Scene& scene, const State& initial);

/// Tool temperatures a cycle later, where that can be told.
using CycleMap = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)>;

/// Temperatures at the start of each cycle from one swab to the next, the first just after swabs of all tools.
/// Production goes on around `settled`, which the mean of the swabs leaves as it is; what a swab has left is followed
/// until it is small against `tolerance`, K. Where tools are swabbed after different numbers of cycles, over the
/// largest. Empty where the map fails.
std::vector<Eigen::VectorXd> since_swab(const SwabImprint& imprint, const Eigen::VectorXd& settled,
                                        const CycleMap& next, double tolerance);

/// When a tool serves one container, s since its gob was loaded, by the planned durations of the stages.
struct ToolUse {
  double begin, end;  ///< both 0 for a tool that no stage uses
};

/// The cycle of a machine that makes one container after another with the same tools. At the time `seconds` after a
/// container's start the next one starts. Each tool has a cycle of its own, as long: from the start of its container,
/// or from its first use where it still serves the container before at that start, as a blow mould may while the blank
/// side goes on.
struct MachineCycle {
  double seconds;
  std::vector<ToolUse> uses;  ///< by tool
  std::vector<int> sets;      ///< of each tool, that take turns; each set has a cycle so many times as long
  std::string key = {};       ///< the option or the key of the case that says `seconds`

  double seconds_of(std::size_t tool) const { return seconds * sets[tool]; }
  bool overlaps(std::size_t tool) const { return uses[tool].end > seconds_of(tool) * (1 + 1e-9); }
};

/// Throws core::CaseError, with the option that named it, where a scene has no tool of a name.
void require_tool(const Scene& scene, const std::string& option, const std::string& name);

/// The cycle of a scene, of the time given or else that of its [timing]; `sets` of tools by name, one of each other.
/// Throws core::CaseError where there is no time, where it is too short for a tool or one that no machine has, and
/// where the state of the tools cannot be periodic.
MachineCycle machine_cycle(const Scene& scene, const std::optional<double>& seconds,
                           const std::map<std::string, int>& sets = {});

/// A sentence where the cycle is unusually long or short, and for each tool from which nothing but air at its contact
/// surface takes heat, and each boundary that is cooled by what is hotter than the glass.
std::vector<std::string> notes_on_cycle(const Scene& scene, const MachineCycle& cycle);

/// The case as each container of the cycle goes through it: tools that still serve the container before at its start
/// have their temperatures at their first use.
Scene scene_in_cycle(const Scene& scene, const MachineCycle& cycle);

}  // namespace parison::forming
