#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "contact/mortar/contact_end.hpp"
#include "contact/mortar/mortar.hpp"
#include "contact/mortar/segments.hpp"

namespace parison::contact {

/// The gap along a segment, m: linear between its ends. On an edge in contact at both its ends it is reduced by the
/// height of the slave's smooth convex surface over the edge (chord_offset) as far as that height explains it: not
/// where the tool is more than twice as far away, as in a corner that the glass does not fill.
class SegmentGap {
 public:
  SegmentGap(const EdgeView& view, const Segment& segment, const Master& master);
  /// The same for a segment on an edge on which a contact ends.
  SegmentGap(const EdgeView& view, const Segment& segment, const ContactEnd& end);
  double operator()(double s) const;
  /// At the ends, m, without the height of the smooth surface.
  double first() const { return first_; }
  double last() const { return last_; }
  double begin() const { return begin_; }
  double end() const { return end_; }

 private:
  const RayEdge* slave_;
  double begin_, end_, first_, last_, chord_ = 0;
  std::optional<ContactEnd> contact_end_;
};

/// Gap of the slave's point at s to the master's exact profile, m; +infinity where that is not known.
double exact_gap(const EdgeView& view, double s, const Master& master);
/// Whether the gap in the middle of a segment is the mean of its ends, to half a per cent of the transition gap, or all
/// three are so large or so small that the contact weight does not change between them.
bool is_linear(const EdgeView& view, const SegmentGap& gap, const Master& master);

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
