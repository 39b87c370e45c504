#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::bench {

/// CPU time of this process so far, s.
double cpu_seconds();

/// The least that a flow step can cost: numeric factorisation and one solve of its matrix, the analysis kept.
class BareFlow {
 public:
  BareFlow();
  ~BareFlow();

  /// CPU time for the matrix of a state's glass with its closed contacts constrained, median of three, s. Throws when
  /// the solution leaves a residual that shows it is none.
  double seconds(const forming::Scene& scene, const forming::State& state);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace parison::bench
