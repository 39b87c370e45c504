#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/cell_batch.hpp"
#include "core/mesh/element.hpp"

namespace parison::thermal {

using core::Geometry;
using core::Index;
using core::Point;

/// Half-line in space: x and y span the planes across the axis and z is along it; of a slab y is the depth.
struct Ray {
  Eigen::Vector3d origin, direction;  ///< m; of length 1

  Eigen::Vector3d at(double distance) const { return origin + distance * direction; }
};

/// Straight piece of a section's outline, turned around the axis to a frustum.
struct Facet {
  Point from, along, normal;  ///< normal outward, of length 1
  Index edge;
  double s;  ///< of its first end
};

/// Where a ray meets a facet.
struct FacetHit {
  double distance;   ///< m
  Index facet = -1;  ///< none where negative
  bool from_behind = false;
};

/// Facets in boxes in boxes, by which a ray finds the nearest one: four children of a node and four facets of a leaf
/// are tested at once (I. Wald, C. Benthin, S. Boulos, Proc. IEEE Symp. Interactive Ray Tracing (2008) 49-57).
class FacetTree {
 public:
  /// `tiny` is the smallest distance between two places, m. With `both_sides` a ray also meets facets from behind.
  FacetTree(const std::vector<Facet>& facets, Geometry geometry, double tiny, bool both_sides);

  /// The nearest facet whose normal has a positive product with `sense` times the direction.
  FacetHit first_hit(const Ray& ray, Index from_facet, double sense) const;

  struct Node {
    core::VectorizedArray low_z, high_z, low_r, high_r;  ///< squares of the radii; of a slab its coordinate
    std::array<Index, core::batch_size> child;           ///< negative: a leaf, -1 - its number
  };
  struct Leaf {
    core::VectorizedArray r, z, along_r, along_z, normal_r, normal_z, off;  ///< off: from its plane, m
  };
  const Node& node(Index i) const { return nodes_[i]; }
  const Leaf& leaf(Index i) const { return leaves_[i]; }
  double tiny() const { return tiny_; }
  bool both_sides() const { return both_sides_; }

 private:
  struct Box {
    Point low, high;
  };
  Index add_node(const std::vector<Box>& boxes, Index first, Index last);

  Geometry geometry_;
  double tiny_;
  bool both_sides_;
  std::vector<Node> nodes_;  ///< the last one has all
  std::vector<Leaf> leaves_;
};

}  // namespace parison::thermal
