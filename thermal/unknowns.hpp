#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "core/case/time_function.hpp"
#include "thermal/heat_balance.hpp"

namespace parison::thermal {

/// Unknown whose temperature is prescribed.
struct PrescribedUnknown {
  Index unknown, body;
  const core::TimeFunction* temperature;  ///< K, of a body of the problem
  Index boundary;                         ///< counted through all bodies
};

/// The unknowns of heat equations d/dt content(T) = power(t, T) in the plane or in space, the nodal temperatures, K,
/// body after body, and what the balance of heat counts.
struct HeatUnknowns {
  std::vector<Index> first_unknown;   ///< of each body; the last entry is the number of unknowns
  std::vector<Index> first_boundary;  ///< of each body, in the count through all bodies; the last entry is their number
  Eigen::VectorXd source;             ///< power of the volume source into each unknown at a source factor of 1, W
  Eigen::VectorXd body_source;        ///< the same for each body, W
  std::vector<std::pair<Index, Index>> pairs;  ///< slave and master body of each pair of bodies in contact
  std::vector<PrescribedUnknown> prescribed;
  std::vector<char> is_prescribed;  ///< by unknown

  Index size() const { return first_unknown.back(); }
  Index body_count() const { return static_cast<Index>(first_unknown.size()) - 1; }
  Index size_of(Index body) const { return first_unknown[body + 1] - first_unknown[body]; }
};
/// Numbers the unknowns and boundaries of bodies, given by how many nodes and boundaries each has; no sources yet.
void number_unknowns(HeatUnknowns& unknowns, const std::vector<std::pair<Index, Index>>& nodes_and_boundaries);
/// Prescribes an unknown of a body, unless it is already.
void prescribe(HeatUnknowns& unknowns, const PrescribedUnknown& at);
/// Index of a pair of bodies, which is added where it is new.
Index find_pair(HeatUnknowns& unknowns, const std::pair<Index, Index>& pair);

/// Heat flows that the balance accumulates, W.
struct Flows {
  Eigen::VectorXd to_air, from_source;  ///< by body
  Eigen::VectorXd light_to_air;         ///< by body: the part of `to_air` that is light of a model with bands
  Eigen::VectorXd across, received;     ///< by pair: out of the slave's nodes, into the master's nodes
  Eigen::VectorXd radiated;             ///< by pair: the part of `across` that is light
  Eigen::VectorXd exchanged;            ///< to_air by boundary, counted through all bodies
  Eigen::VectorXd from_enclosure;       ///< by body: light from other surfaces, by which `to_air` is less
};
/// Terms of the heat equations at a time and temperatures.
struct Response {
  Eigen::VectorXd content;  ///< by unknown: integral of density times enthalpy times shape function, J; or its rate, W
  Eigen::VectorXd power;    ///< heat into each unknown by conduction, exchange, interface and source, W
  Flows flows;
};
/// Factors on the sources of a problem's bodies at a time, s.
template <typename Bodies>
Eigen::VectorXd source_factors(const Bodies& bodies, double time) {
  Eigen::VectorXd factors(static_cast<Index>(bodies.size()));
  for (Index b = 0; b < factors.size(); ++b) factors[b] = bodies[b].source_factor(time);
  return factors;
}
/// Flows of the sources alone.
Flows source_flows(const HeatUnknowns& unknowns, const Eigen::VectorXd& factors);

/// Sets the prescribed unknowns, K, to their values at a time; false where none changes.
bool impose_prescribed(const HeatUnknowns& unknowns, double time, Eigen::VectorXd& temperature);
/// Sets a vector to zero where the temperature is prescribed.
void clear_prescribed(const HeatUnknowns& unknowns, Eigen::Ref<Eigen::VectorXd> values);

/// A balance with these bodies and pairs and all entries zero.
HeatBalance zero_balance(const HeatUnknowns& unknowns);
/// Accumulates flows that lasted `duration` seconds.
void accumulate(HeatBalance& balance, const Flows& flows, double duration);
/// Accumulates heat, J, that entered through a prescribed unknown.
void accumulate_prescribed(HeatBalance& balance, const PrescribedUnknown& at, double heat);
/// Takes the content change of a balance that has nothing else as heat through the prescribed boundaries: that of each
/// body as through its first one.
void accumulate_imposed(HeatBalance& balance, const HeatUnknowns& unknowns);
/// Accumulates the change between two contents of the unknowns, J.
void accumulate_content(HeatBalance& balance, const HeatUnknowns& unknowns, const Eigen::VectorXd& before,
                        const Eigen::VectorXd& after);

/// The unknowns of all bodies in one vector from the nodal temperatures of each body, and back, K.
Eigen::VectorXd join(const HeatUnknowns& unknowns, const std::vector<Eigen::VectorXd>& temperature);
std::vector<Eigen::VectorXd> split(const HeatUnknowns& unknowns, const Eigen::VectorXd& joined);

}  // namespace parison::thermal
