#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <limits>
#include <vector>

namespace parison::core {

/// Anderson's acceleration of an iteration x = G(x), also of one that diverges in a few directions: the next x is the
/// combination of the last ones whose residuals G(x) - x add up to least (D. G. Anderson, J. ACM 12 (1965) 547-560;
/// H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735).
class AndersonAcceleration {
 public:
  /// Remembers the last `depth` changes.
  explicit AndersonAcceleration(std::size_t depth = std::numeric_limits<std::size_t>::max()) : depth_(depth) {}

  /// The next x, from an x and its G(x).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& image);
  /// Leaves the last ones aside, where G has changed.
  void forget() { *this = AndersonAcceleration(depth_); }

  /// The move to the next x, from what G moves the present one by: the same without x itself.
  Eigen::VectorXd next_move(const Eigen::VectorXd& update);

  /// What both are made of: remembers by how much G(x) and G(x) - x changed; G(x) less what the changes explain of its
  /// residual, in a frame of the caller's.
  void add(const Eigen::VectorXd& image_change, const Eigen::VectorXd& residual_change);
  Eigen::VectorXd accelerated(const Eigen::VectorXd& image, const Eigen::VectorXd& residual) const;

 private:
  std::size_t depth_, added_ = 0;
  std::vector<Eigen::VectorXd> image_change_, residual_change_;
  Eigen::VectorXd image_, residual_;  ///< the last ones; of moves the last move and update
};

}  // namespace parison::core
