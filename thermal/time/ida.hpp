#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"

namespace parison::thermal {

struct IdaOptions {
  double tolerance = 0.01;  ///< local error of a step, root mean square over the nodes, K
};

struct IdaOutcome {
  bool converged = false;
  std::string reason;
  std::vector<Eigen::VectorXd> temperature;  ///< per body and node, K
  HeatBalance balance;                       ///< since the last call; closes to the tolerance
  long steps = 0, factorisations = 0;        ///< since the last call
};

/// Heat while meshes, interface and surroundings stand still: SUNDIALS IDA (variable order and step) with a Cholesky
/// factor, on capacity(T) dT/dt = power(T). Its history serves from call to call, so frequent output costs nothing.
class IdaIntegrator {
 public:
  IdaIntegrator(Problem problem, const std::vector<Eigen::VectorXd>& temperature, const IdaOptions& options);
  ~IdaIntegrator();
  IdaIntegrator(IdaIntegrator&&) noexcept;
  IdaIntegrator& operator=(IdaIntegrator&&) noexcept;

  /// Integrates to `time`, s since the start, later than the last.
  IdaOutcome advance_to(double time);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::thermal
