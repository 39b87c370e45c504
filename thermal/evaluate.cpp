// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/cell_kernels.hpp"

namespace parison::thermal {

namespace {

Flows zero_flows(const HeatSystem& system) {
  const auto bodies = static_cast<Index>(system.bodies.size()), pairs = static_cast<Index>(system.pairs.size());
  return {Eigen::VectorXd::Zero(bodies), system.body_source, Eigen::VectorXd::Zero(pairs), Eigen::VectorXd::Zero(pairs)};
}

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd* rate) {
  Response response{Eigen::VectorXd::Zero(system.size()), system.source, zero_flows(system)};
  add_cells(system, temperature, rate, response);
  add_exchange(system, temperature, response.flows, &response.power);
  return response;
}

}  // namespace

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  return evaluate(system, temperature, nullptr);
}

Response evaluate(const HeatSystem& system, const Eigen::VectorXd& temperature, const Eigen::VectorXd& rate) {
  return evaluate(system, temperature, &rate);
}

Flows evaluate_flows(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  Flows flows = zero_flows(system);
  add_exchange(system, temperature, flows, nullptr);
  return flows;
}

}  // namespace parison::thermal
