#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "contact/mortar/mortar.hpp"
#include "contact/mortar/segments.hpp"

namespace parison::contact {

/// The gap along a segment: linear between its ends; on an edge that is closed at both its ends, less what the slave's
/// smooth surface stands out of it.
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

/// Whether a stretch of a segment is as good as closed all along: to a fiftieth of the transition gap, where the
/// contact weight changes by less than 1e-4 and its integral needs no more points.
bool is_in_contact(const SegmentGap& gap, double begin, double end, double width);

/// How a segment is closed: touching all along; with gaps so small that its contact weight is smooth and all but 1; or
/// else.
enum class ContactStatus { touching, near, open };
ContactStatus contact_status(const SegmentGap& gap, double width);

/// Ends of the parts of a stretch, in order.
struct Parts {
  std::array<double, 4> end;
  int count;  ///< of the ends
};
/// The parts of a segment: it is cut where the gap passes the ends of the transition, so that the contact weight is
/// smooth on each.
Parts cut_at_transition(const SegmentGap& gap, double width);

}  // namespace parison::contact
