// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/heat_balance.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace parison::thermal {

double lost_through_interfaces(const Ledger& ledger, Index body) {
  double lost = 0;
  for (const PairLedger& pair : ledger.pairs) {
    if (pair.slave_body == body) lost += pair.heat;
    if (pair.master_body == body) lost -= pair.received;
  }
  return lost;
}

double imbalance(const Ledger& ledger, Index body) {
  const BodyLedger& b = ledger.bodies[body];
  return b.content_change - (b.from_source + b.from_prescribed - b.to_air - lost_through_interfaces(ledger, body));
}

double flux_mismatch(const Ledger& ledger) {
  double difference = 0, largest = 0;
  for (const PairLedger& pair : ledger.pairs) {
    difference = std::max(difference, std::abs(pair.heat - pair.received));
    largest = std::max(largest, std::abs(pair.heat));
  }
  return largest > 0 ? difference / largest : 0;
}

void add(Ledger& ledger, const Ledger& step) {
  if (ledger.bodies.empty()) ledger.bodies.resize(step.bodies.size());
  assert(ledger.bodies.size() == step.bodies.size());
  for (std::size_t b = 0; b < step.bodies.size(); ++b) {
    ledger.bodies[b].content_change += step.bodies[b].content_change;
    ledger.bodies[b].to_air += step.bodies[b].to_air;
    ledger.bodies[b].from_source += step.bodies[b].from_source;
    ledger.bodies[b].from_prescribed += step.bodies[b].from_prescribed;
  }
  for (const PairLedger& pair : step.pairs) {
    const auto same = std::find_if(ledger.pairs.begin(), ledger.pairs.end(), [&](const PairLedger& p) {
      return p.slave_body == pair.slave_body && p.master_body == pair.master_body;
    });
    if (same == ledger.pairs.end()) {
      ledger.pairs.push_back(pair);
    } else {
      same->heat += pair.heat;
      same->received += pair.received;
    }
  }
}

}  // namespace parison::thermal
