#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// Taylor-Hood solver with unilateral contact (primal-dual active set) for one mesh topology; its pattern and symbolic
/// analysis are kept, so use one Solver until the mesh is renewed.
class Solver {
 public:
  explicit Solver(const core::Mesh& mesh);
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// Velocity, pressure and contact of one instant. `warm` is the guess of the active candidates (may be empty: those
  /// without a gap). A failure is returned with its reason.
  Solution solve(const Problem& problem, const std::vector<bool>& warm);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::flow
