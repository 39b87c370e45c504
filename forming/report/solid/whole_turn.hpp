#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// The whole turn about the axis from a sector between planes of symmetry: every second copy is mirrored.
class Copies {
 public:
  explicit Copies(const SolidState& solid);
  int count() const { return count_; }
  static bool is_mirrored(int copy) { return copy % 2 == 1; }
  /// A point of a copy, mm, to a nanometre: copies meet in the same nodes.
  core::Vector3 millimetres(const core::Vector3& at, int copy) const;

 private:
  int count_;
  double sector_;  ///< rad
};

}  // namespace parison::forming
