#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <vector>

#include "thermal/solid/solid_system.hpp"
#include "thermal/time/substeps.hpp"

namespace parison::thermal {

/// Matrix of the stages. The pattern has all faces and all pairs of faces that the interface names, near ones included;
/// it is made anew where a mesh changes or a pair comes in that it does not have.
struct SolidStepMatrix : HeatMatrix {
  Index analyses = 0;

  /// Forgets what steps before have left, so that the next one is as of a new matrix. An order of elimination that this
  /// would find again stays.
  void begin_anew() {
    factored_step = 0;
    begins_anew = true;
  }

  // What the pattern was made for.
  bool begins_anew = false;
  bool is_dissected = false;      ///< whether the order of elimination was found for this very pattern
  double ordered_operations = 0;  ///< of a factorisation when the order of elimination was found
  std::vector<Index> mesh_signature;
  std::map<std::array<Index, 4>, Index> pair_clique;     ///< by FacePair::key()
  std::vector<std::vector<std::array<int, 2>>> repeats;  ///< by clique: entries whose unknown comes twice
};

/// Makes the pattern fit a system. The factor of a step before stays, where the pattern does: it serves while the
/// stages converge with it.
void prepare(SolidStepMatrix& matrix, const SolidSystem& system);
/// Assembles and factorises at a time, s, and temperatures, K; false when the matrix is not positive definite.
bool factorise(SolidStepMatrix& matrix, const SolidSystem& system, double time, const Eigen::VectorXd& temperature,
               double step);

}  // namespace parison::thermal
