// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/mortar/segment_gap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "contact/mortar/root.hpp"
#include "core/math/numbers.hpp"

namespace parison::contact {

namespace {

constexpr double touching = 1e-9;          ///< tolerance of a gap, in transition gaps
constexpr double full_contact_gap = 0.02;  ///< largest gap of a segment that is `near`, in transition gaps

/// Largest difference of a linear gap from the exact one, in transition gaps.
constexpr double linear_gap = 0.005;

/// Whether the gap changes sign between a segment's ends, where it is `first` and `last`.
bool passes_zero(double first, double last, double width) {
  return std::min(first, last) < -touching * width && std::max(first, last) > touching * width;
}

}  // namespace

double contact_weight(double gap, double width) {
  if (gap <= 0) return 1;
  if (!(gap < width)) return 0;
  const double u = gap / width;
  return 1 - u * u * u * (10 - 15 * u + 6 * u * u);
}

double exact_gap(const EdgeView& view, double s, const Master& master) {
  return master.gap_at ? master.gap_at(position(view.slave.edge, s)) : core::infinity;
}

SegmentGap::SegmentGap(const EdgeView& view, const Segment& segment, const Master& master)
    : slave_(&view.slave), begin_(segment.begin.slave_s), end_(segment.end.slave_s) {
  // A node has its gap to the exact profile. Where that is not known or out of reach, the distance to the master's mesh
  // along the ray counts; a mesh that lies behind the slave by more than the transition gap is not in contact.
  const auto at = [&](const InterfaceNode& node) {
    const bool of_slave = node.slave_node >= 0;
    const double known =
        of_slave ? master.gap[slave_->edge.nodes[node.slave_node]] : exact_gap(view, node.slave_s, master);
    if (std::isfinite(known)) return known;
    const auto hit = hit_master(ray(*slave_, node.slave_s), view.masters[segment.edge].edge);
    const double distance = hit ? hit->distance : view.range;
    return of_slave && distance < -master.transition_gap ? master.transition_gap : distance;
  };
  first_ = at(segment.begin);
  last_ = at(segment.end);
  const auto weight = [&](int i) { return contact_weight(master.gap[slave_->edge.nodes[i]], master.transition_gap); };
  chord_ = weight(0) * weight(1);
}

SegmentGap::SegmentGap(const EdgeView& view, const Segment& segment, const ContactEnd& end)
    : slave_(&view.slave),
      begin_(segment.begin.slave_s),
      end_(segment.end.slave_s),
      first_(end(begin_)),
      last_(end(end_)),
      contact_end_(end) {}

double SegmentGap::operator()(double s) const {
  if (contact_end_) return (*contact_end_)(s);
  const double along = (s - begin_) / (end_ - begin_), gap = first_ + along * (last_ - first_);
  const double height = chord_ * chord_offset(*slave_, s);
  return height > 0 ? gap - height * contact_weight(gap - height, height) : gap;
}

bool is_in_contact(const SegmentGap& gap, double begin, double end, double width) {
  const double most = full_contact_gap * width;
  return gap(begin) <= most && gap(end) <= most && gap(0.5 * (begin + end)) <= most;
}

bool is_linear(const EdgeView& view, const SegmentGap& gap, const Master& master) {
  const double begin = gap.first(), end = gap.last();
  const double middle = exact_gap(view, 0.5 * (gap.begin() + gap.end()), master);
  if (!std::isfinite(middle)) return true;
  const double width = master.transition_gap;
  const bool is_in_transition =
      std::min({begin, middle, end}) < width && std::max({begin, middle, end}) > full_contact_gap * width;
  return !is_in_transition || std::abs(middle - 0.5 * (begin + end)) <= linear_gap * width;
}

ContactStatus contact_status(const SegmentGap& gap, double width) {
  const double most = full_contact_gap * width, first = gap(gap.begin()), last = gap(gap.end());
  if (!(first <= most && last <= most) || passes_zero(first, last, width)) return ContactStatus::open;
  const double middle = gap(0.5 * (gap.begin() + gap.end()));
  if (!(middle <= most)) return ContactStatus::open;
  return middle <= touching * width ? ContactStatus::touching : ContactStatus::near;
}

Parts cut_at_transition(const SegmentGap& gap, double width) {
  Parts parts{{gap.begin()}, 1};
  for (const double level : {0.0, width}) {
    const auto excess = [&](double s) { return gap(s) - level; };
    const double first = excess(gap.begin()), last = excess(gap.end());
    if (passes_zero(first, last, width))
      parts.end[parts.count++] = find_root(excess, gap.begin(), first, gap.end(), last);
  }
  if (parts.count == 3 && parts.end[1] > parts.end[2]) std::swap(parts.end[1], parts.end[2]);
  parts.end[parts.count++] = gap.end();
  return parts;
}

void cut_at_zeros(const std::array<double, 3>& values, Parts& parts) {
  constexpr double apart = 1e-6;  // of the edge, from another end
  const auto [first, last, middle] = values;
  const double a = 2 * (first + last) - 4 * middle, b = 4 * middle - 3 * first - last;
  const double square = b * b - 4 * a * first;
  if (!(square > 0)) return;
  const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));  // not the difference of near numbers
  for (const double root : {q / a, first / q}) {
    const auto end = parts.end.begin() + parts.count;
    const auto above = std::upper_bound(parts.end.begin(), end, root);
    if (above == parts.end.begin() || above == end || *above - root < apart || root - *(above - 1) < apart) continue;
    std::copy_backward(above, end, end + 1);
    *above = root;
    ++parts.count;
  }
}

}  // namespace parison::contact
