#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::thermal {

using core::Index;

/// Heat balance of one body over a time, J.
struct BodyBalance {
  double content_change = 0;
  double to_air = 0;           ///< out by convection and radiation to the surroundings, cooling included
  double light_to_air = 0;     ///< the part of `to_air` that is light of a model with bands
  double from_enclosure = 0;   ///< light from other surfaces than the surroundings, by which `to_air` is less
  double from_source = 0;      ///< in from the volume source
  double from_prescribed = 0;  ///< in through boundaries of prescribed temperature
};

/// Heat that crossed the interface from a slave to a master over a time, J, summed over the nodes of each side.
struct PairBalance {
  Index slave_body, master_body;
  double heat = 0;      ///< out of the slave
  double received = 0;  ///< into the master
  double radiated = 0;  ///< the part of `heat` that went as light through the glass surface, of models with bands
};

/// Heat balance of all bodies over a time.
struct HeatBalance {
  std::vector<BodyBalance> bodies;
  std::vector<PairBalance> pairs;
  std::vector<Index> first_boundary;     ///< of each body in the count through all bodies, and their number
  std::vector<double> through_boundary;  ///< out by exchange and prescribed temperature, J, in that count
};

/// Heat that a body lost through its interfaces, J; negative for a master that the slave heats.
double lost_through_interfaces(const HeatBalance& balance, Index body);
/// Residual of a body's balance, J: the content change less all heat that entered.
double imbalance(const HeatBalance& balance, Index body);
/// Largest difference between the heat out of a slave and into its master, relative to the largest heat of any pair.
double flux_mismatch(const HeatBalance& balance);
/// Adds the entries of `step`, which must have the same bodies; pairs that are new are appended.
void add(HeatBalance& balance, const HeatBalance& step);

}  // namespace parison::thermal
