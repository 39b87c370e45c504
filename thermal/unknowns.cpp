// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/unknowns.hpp"

#include <algorithm>
#include <cassert>

namespace parison::thermal {

void number_unknowns(HeatUnknowns& unknowns, const std::vector<std::pair<Index, Index>>& nodes_and_boundaries) {
  unknowns.first_unknown = unknowns.first_boundary = {0};
  for (const auto& [nodes, boundaries] : nodes_and_boundaries) {
    unknowns.first_unknown.push_back(unknowns.first_unknown.back() + nodes);
    unknowns.first_boundary.push_back(unknowns.first_boundary.back() + boundaries);
  }
  unknowns.source.setZero(unknowns.size());
  unknowns.body_source.setZero(unknowns.body_count());
  unknowns.is_prescribed.assign(static_cast<std::size_t>(unknowns.size()), 0);
}

void prescribe(HeatUnknowns& unknowns, const PrescribedUnknown& at) {
  if (std::exchange(unknowns.is_prescribed[at.unknown], 1)) return;
  unknowns.prescribed.push_back(at);
}

Index find_pair(HeatUnknowns& unknowns, const std::pair<Index, Index>& pair) {
  const auto found = std::find(unknowns.pairs.begin(), unknowns.pairs.end(), pair);
  const auto index = static_cast<Index>(found - unknowns.pairs.begin());
  if (found == unknowns.pairs.end()) unknowns.pairs.push_back(pair);
  return index;
}

Flows source_flows(const HeatUnknowns& unknowns, const Eigen::VectorXd& factors) {
  const auto zero = [](std::size_t count) -> Eigen::VectorXd {
    return Eigen::VectorXd::Zero(static_cast<Index>(count));
  };
  const Eigen::VectorXd no_body = zero(factors.size()), no_pair = zero(unknowns.pairs.size());
  return {no_body, factors.cwiseProduct(unknowns.body_source), no_body, no_pair, no_pair,
          no_pair, zero(unknowns.first_boundary.back()),       no_body};
}

bool impose_prescribed(const HeatUnknowns& unknowns, double time, Eigen::VectorXd& temperature) {
  bool changed = false;
  for (const PrescribedUnknown& at : unknowns.prescribed) {
    const double value = (*at.temperature)(time);
    changed = changed || temperature[at.unknown] != value;
    temperature[at.unknown] = value;
  }
  return changed;
}

void clear_prescribed(const HeatUnknowns& unknowns, Eigen::Ref<Eigen::VectorXd> values) {
  for (const PrescribedUnknown& at : unknowns.prescribed) values[at.unknown] = 0;
}

HeatBalance zero_balance(const HeatUnknowns& unknowns) {
  HeatBalance balance;
  balance.bodies.resize(static_cast<std::size_t>(unknowns.body_count()));
  balance.first_boundary = unknowns.first_boundary;
  balance.through_boundary.assign(static_cast<std::size_t>(unknowns.first_boundary.back()), 0);
  for (const auto& [slave, master] : unknowns.pairs) balance.pairs.push_back({slave, master});
  return balance;
}

void accumulate(HeatBalance& balance, const Flows& flows, double duration) {
  for (std::size_t b = 0; b < balance.bodies.size(); ++b) {
    balance.bodies[b].to_air += duration * flows.to_air[b];
    balance.bodies[b].light_to_air += duration * flows.light_to_air[b];
    balance.bodies[b].from_enclosure += duration * flows.from_enclosure[b];
    balance.bodies[b].from_source += duration * flows.from_source[b];
  }
  for (std::size_t i = 0; i < balance.through_boundary.size(); ++i)
    balance.through_boundary[i] += duration * flows.exchanged[static_cast<Index>(i)];
  for (std::size_t p = 0; p < balance.pairs.size(); ++p) {
    balance.pairs[p].heat += duration * flows.across[p];
    balance.pairs[p].received += duration * flows.received[p];
    balance.pairs[p].radiated += duration * flows.radiated[p];
  }
}

void accumulate_prescribed(HeatBalance& balance, const PrescribedUnknown& at, double heat) {
  balance.bodies[at.body].from_prescribed += heat;
  balance.through_boundary[static_cast<std::size_t>(at.boundary)] -= heat;
}

void accumulate_imposed(HeatBalance& balance, const HeatUnknowns& unknowns) {
  std::vector<char> booked(balance.bodies.size(), 0);
  for (const PrescribedUnknown& at : unknowns.prescribed)
    if (!std::exchange(booked[at.body], 1)) accumulate_prescribed(balance, at, balance.bodies[at.body].content_change);
}

void accumulate_content(HeatBalance& balance, const HeatUnknowns& unknowns, const Eigen::VectorXd& before,
                        const Eigen::VectorXd& after) {
  const Eigen::VectorXd change = after - before;
  for (Index b = 0; b < unknowns.body_count(); ++b)
    balance.bodies[b].content_change += change.segment(unknowns.first_unknown[b], unknowns.size_of(b)).sum();
}

Eigen::VectorXd join(const HeatUnknowns& unknowns, const std::vector<Eigen::VectorXd>& temperature) {
  Eigen::VectorXd joined(unknowns.size());
  for (Index b = 0; b < unknowns.body_count(); ++b) {
    assert(temperature[b].size() == unknowns.size_of(b));
    joined.segment(unknowns.first_unknown[b], unknowns.size_of(b)) = temperature[b];
  }
  return joined;
}

std::vector<Eigen::VectorXd> split(const HeatUnknowns& unknowns, const Eigen::VectorXd& joined) {
  std::vector<Eigen::VectorXd> temperature;
  for (Index b = 0; b < unknowns.body_count(); ++b)
    temperature.push_back(joined.segment(unknowns.first_unknown[b], unknowns.size_of(b)));
  return temperature;
}

}  // namespace parison::thermal
