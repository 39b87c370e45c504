#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::thermal {

using core::Index;

/// Heat that one body exchanged over a step, J.
struct BodyBalance {
  double content_change = 0;
  double to_air = 0;           ///< out through surface exchange: air, cooling and radiation
  double from_source = 0;      ///< in from the volume source
  double from_prescribed = 0;  ///< in through boundaries of given temperature
};

/// Heat that crossed the interface from a slave to a master, J, summed over either side's own nodes.
struct PairBalance {
  Index slave_body, master_body;
  double heat = 0;      ///< out of the slave
  double received = 0;  ///< into the master
};

struct HeatBalance {
  std::vector<BodyBalance> bodies;
  std::vector<PairBalance> pairs;
};

/// Heat that a body lost through its interfaces, J; negative for a master that was heated.
double lost_through_interfaces(const HeatBalance& balance, Index body);
/// What the balance of a body leaves unexplained, J.
double imbalance(const HeatBalance& balance, Index body);
/// Largest difference between what a slave gave and what its master received, relative to the largest heat of any pair.
double flux_mismatch(const HeatBalance& balance);
/// Adds the entries of `step`, which has the same bodies; pairs are matched or appended.
void add(HeatBalance& balance, const HeatBalance& step);

}  // namespace parison::thermal
