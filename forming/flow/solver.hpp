#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "forming/flow/solution.hpp"

namespace parison::flow {

class Corrector;

/// Solver of quasi-static viscous flow with unilateral contact for one mesh topology. The sparsity pattern and its
/// symbolic factorisation are kept, so one Solver serves until the glass is remeshed.
///
/// Contacts are found by the primal-dual active set strategy (M. Hintermueller, K. Ito, K. Kunisch, 2002, SIAM J.
/// Optim. 13, 865-888): every iteration solves the equations with the active contacts as equalities, opens those in
/// tension and closes those that would be penetrated, until nothing changes. Shear thinning (Newton's method) and
/// Coulomb's friction (fixed-point iteration) are updated in the same iterations; the last one may be repeated once as
/// iterative refinement.
class Solver {
 public:
  explicit Solver(const core::Mesh& mesh);
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// Equilibrium of one instant. `initial_active` is a guess of the active set, one flag per candidate; empty: the
  /// candidates without a gap. A failure is returned with its reason.
  Equilibrium find_equilibrium(const Problem& problem, const std::vector<bool>& initial_active);
  /// The same, evaluated.
  Solution solve(const Problem& problem, const std::vector<bool>& initial_active);

 private:
  std::unique_ptr<Corrector> corrector_;
};

}  // namespace parison::flow
