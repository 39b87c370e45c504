#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"

namespace parison::thermal {

/// Error control of IDA.
struct IdaOptions {
  double tolerance = 0.01;  ///< local error of a step, the largest of any node, K
};

/// Result of a call; without convergence only `reason` is set.
struct IdaOutcome {
  bool converged = false;
  std::string reason;                        ///< why it did not converge
  std::vector<Eigen::VectorXd> temperature;  ///< by body and node, K
  HeatBalance balance;                       ///< since the last call; closes to the tolerance
  long steps = 0, factorisations = 0;        ///< since the last call
};

/// Time integrator for a problem whose meshes and interface do not move: SUNDIALS IDA (Hindmarsh et al. 2005), backward
/// differentiation formulas of variable order and step, with a Cholesky factor, on capacity(T) dT/dt = power(t, T).
/// Prescribed temperatures are inserted as functions of time. The history is kept from call to call, so output at many
/// times costs no more steps.
class IdaIntegrator {
 public:
  /// Starts at `time`, s, from the nodal temperatures by body, K; prescribed temperatures are imposed.
  IdaIntegrator(Problem problem, double time, const std::vector<Eigen::VectorXd>& temperature,
                const IdaOptions& options);
  ~IdaIntegrator();
  IdaIntegrator(IdaIntegrator&&) noexcept;
  IdaIntegrator& operator=(IdaIntegrator&&) noexcept;

  /// Integrates to `time`, s, which must be later than that of the last call and the start.
  IdaOutcome advance_to(double time);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::thermal
