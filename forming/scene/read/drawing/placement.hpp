#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/case_file.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

/// A shift, a turn, one scale and perhaps a reflection.
struct Placement {
  core::Point base = core::Point::Zero(), place = core::Point::Zero();  ///< m; the base comes to the place
  double turn = 0, scale = 1;                                           ///< rad counterclockwise, above zero
  bool mirrored = false;                                                ///< x becomes -x, before the turn

  core::Segment operator()(const core::Segment& segment) const;
};

/// Puts the curves of a drawing where its keys say: `origin`, the point that is (0, 0) of the case; `axis`, the
/// direction in the drawing that is that of z; `turn`, an angle by which it is turned instead. With an axis, where
/// `from` and `to` lie on an outline at negative radii alone, it comes to the other side: around an axis both are the
/// same. Of a solid that has been cut, the latter two are done.
void place(const core::CaseTable& table, bool is_cut, std::vector<core::Segment>& curves);

}  // namespace parison::forming
