#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/solid/quad_face.hpp"

namespace parison::contact {

/// Axis-parallel box in space, m.
struct SpaceBox {
  core::Vector3 low, high;
  bool meets(const SpaceBox& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
/// Box around the nodes of a face, widened on all sides, m. A curved face leaves it by little: widen it for that.
SpaceBox box_around(const std::vector<core::Vector3>& nodes, const core::QuadFace& face, double widened);

/// Boxes listed in the bins of a uniform grid that they touch.
class BoxSearch {
 public:
  explicit BoxSearch(std::vector<SpaceBox> boxes);
  /// Numbers of the boxes that meet one, each once, rising.
  std::vector<core::Index> find(const SpaceBox& box) const;

 private:
  using Bin = std::array<core::Index, 3>;
  Bin bin_at(const core::Vector3& x) const;
  template <typename Visit>
  void for_each_bin(const SpaceBox& box, const Visit& visit) const;

  std::vector<SpaceBox> boxes_;
  core::Vector3 low_ = core::Vector3::Zero();
  double size_ = 1;
  Bin count_{1, 1, 1};
  std::vector<core::Index> start_, listed_;
};

}  // namespace parison::contact
