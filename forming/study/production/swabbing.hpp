#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
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

}  // namespace parison::forming
