#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "contact/mortar/mortar.hpp"
#include "contact/mortar/segments.hpp"

namespace parison::contact {

/// The gap along a segment, m: linear between its ends. On an edge in contact at both its ends it is reduced by the
/// height of the slave's smooth convex surface over the edge (chord_offset).
class SegmentGap {
 public:
  SegmentGap(const EdgeView& view, const Segment& segment, const Master& master);
  double operator()(double s) const {
    const double along = (s - begin_) / (end_ - begin_);
    return first_ + along * (last_ - first_) - chord_ * std::max(0.0, chord_offset(*slave_, s));
  }
  double begin() const { return begin_; }
  double end() const { return end_; }

 private:
  const RayEdge* slave_;
  double begin_, end_, first_, last_, chord_;
};

/// Whether the gap along a part of a segment stays below a fiftieth of the transition gap. There the contact weight
/// differs from 1 by less than 1e-4 and needs no additional Gauss points.
bool is_in_contact(const SegmentGap& gap, double begin, double end, double width);

/// Contact along a segment: without a gap everywhere (touching), with gaps below a fiftieth of the transition gap
/// (near), or with larger gaps (open).
enum class ContactStatus { touching, near, open };
ContactStatus contact_status(const SegmentGap& gap, double width);

/// Division of a segment into parts: its ends and the cuts between them, in order.
struct Parts {
  std::array<double, 6> end;
  int count;  ///< number of ends and cuts
};
/// Cuts parts where a quadratic along the edge, given by its values at s = 0, 1 and 0.5, passes zero.
void cut_at_zeros(const std::array<double, 3>& values, Parts& parts);
/// Cuts a segment where the gap passes 0 and the transition gap, so that the contact weight is a polynomial of the gap
/// on each part.
Parts cut_at_transition(const SegmentGap& gap, double width);

}  // namespace parison::contact
