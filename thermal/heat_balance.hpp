#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::thermal {

using core::Index;

/// Heat that one body exchanged over a step, J.
struct BodyLedger {
  double content_change = 0;
  double to_air = 0;           ///< out through surface exchange: air, cooling and radiation
  double from_source = 0;      ///< in from the volume source
  double from_prescribed = 0;  ///< in through pieces of given temperature
};

/// Heat that crossed the interface from a slave to a master, J, summed over either side's own nodes.
struct PairLedger {
  Index slave_body, master_body;
  double heat = 0;      ///< out of the slave
  double received = 0;  ///< into the master
};

struct Ledger {
  std::vector<BodyLedger> bodies;
  std::vector<PairLedger> pairs;
};

/// Heat that a body lost through its interfaces, J; negative for a master that was heated.
double lost_through_interfaces(const Ledger& ledger, Index body);
/// What the balance of a body leaves unexplained, J.
double imbalance(const Ledger& ledger, Index body);
/// Largest difference between what a slave gave and what its master received, relative to the largest heat of any pair.
double flux_mismatch(const Ledger& ledger);
/// Adds the entries of `step`, which has the same bodies; pairs are matched or appended.
void add(Ledger& ledger, const Ledger& step);

}  // namespace parison::thermal
