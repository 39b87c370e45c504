// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/heat_balance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace parison::thermal {

double lost_through_interfaces(const HeatBalance& balance, Index body) {
  double lost = 0;
  for (const PairBalance& pair : balance.pairs) {
    if (pair.slave_body == body) lost += pair.heat;
    if (pair.master_body == body) lost -= pair.received;
  }
  return lost;
}

double imbalance(const HeatBalance& balance, Index body) {
  const BodyBalance& b = balance.bodies[body];
  return b.content_change - (b.from_source + b.from_prescribed - b.to_air - lost_through_interfaces(balance, body));
}

double flux_mismatch(const HeatBalance& balance) {
  double difference = 0, largest = 0;
  for (const PairBalance& pair : balance.pairs) {
    difference = std::max(difference, std::abs(pair.heat - pair.received));
    largest = std::max(largest, std::abs(pair.heat));
  }
  return largest > 0 ? difference / largest : 0;
}

void add(HeatBalance& balance, const HeatBalance& step) {
  if (balance.bodies.empty()) balance.bodies.resize(step.bodies.size());
  assert(balance.bodies.size() == step.bodies.size());
  if (balance.through_boundary.empty()) {
    balance.first_boundary = step.first_boundary;
    balance.through_boundary.resize(step.through_boundary.size());
  }
  assert(balance.through_boundary.size() == step.through_boundary.size());
  for (std::size_t i = 0; i < step.through_boundary.size(); ++i)
    balance.through_boundary[i] += step.through_boundary[i];
  for (std::size_t b = 0; b < step.bodies.size(); ++b) {
    balance.bodies[b].content_change += step.bodies[b].content_change;
    balance.bodies[b].to_air += step.bodies[b].to_air;
    balance.bodies[b].light_to_air += step.bodies[b].light_to_air;
    balance.bodies[b].from_enclosure += step.bodies[b].from_enclosure;
    balance.bodies[b].from_source += step.bodies[b].from_source;
    balance.bodies[b].from_prescribed += step.bodies[b].from_prescribed;
  }
  for (const PairBalance& pair : step.pairs) {
    const auto same = std::find_if(balance.pairs.begin(), balance.pairs.end(), [&](const PairBalance& p) {
      return p.slave_body == pair.slave_body && p.master_body == pair.master_body;
    });
    if (same == balance.pairs.end()) {
      balance.pairs.push_back(pair);
    } else {
      same->heat += pair.heat;
      same->received += pair.received;
      same->radiated += pair.radiated;
    }
  }
}

}  // namespace parison::thermal
