#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <memory>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Finds where rays leave a body, by an R-tree of the boxes of its boundary edges. The mesh must outlive it.
class BoundaryRays {
 public:
  /// Edges that a ray meets at a smaller sine than `grazing` run along it and do not count.
  explicit BoundaryRays(const core::Mesh& mesh, double grazing = 0);
  ~BoundaryRays();

  struct Hit {
    double distance = std::numeric_limits<double>::infinity();  ///< m
    core::Index edge = -1;
    double position = 0;  ///< on that edge, 0 to 1
  };
  struct Ray {
    core::Point start, direction;  ///< m; unit
    core::Index node = -1;         ///< at which it starts: its edges do not count
    core::Index edge = -1;         ///< on which it starts, which does not count
  };

  /// First edge at which a ray leaves the body. Edges beyond `reach`, m, may be missed. It is sought as far as
  /// `expected` first, m, which must be above 0: the box of a long ray meets many edges.
  Hit first_exit(const Ray& ray, double reach = std::numeric_limits<double>::infinity(),
                 double expected = std::numeric_limits<double>::infinity()) const;

 private:
  struct Tree;
  void try_edge(const Ray& ray, core::Index edge, Hit& hit) const;

  const core::Mesh& mesh_;
  double grazing_;
  double extent_;  ///< m: no chord of the body is longer
  std::unique_ptr<Tree> tree_;
};

}  // namespace parison::remesh
