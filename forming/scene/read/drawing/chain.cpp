// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;

/// Moves the ends of a curve; an arc turns by the same angle as before.
void move_ends(Segment& curve, const Point& start, const Point& end) {
  if (start == curve.start && end == curve.end) return;
  curve.start = start;
  curve.end = end;
  if (!curve.is_arc) return;
  bend(curve, curve.to - curve.from);
}

/// Brings the end of one curve and the start of the next, which may be the same one, together.
void join(Segment& before, Segment& next) {
  const Point end = before.end, start = next.start;
  const Point middle = before.is_arc == next.is_arc ? Point(0.5 * (start + end)) : before.is_arc ? end : start;
  move_ends(before, before.start, middle);
  move_ends(next, middle, next.end);
}

[[noreturn]] void refuse_gap(const CaseNode& file, double apart, const Point& where, double gap) {
  core::refuse(file,
               fmt::format("the curves of the drawing leave a gap of {:.3g} mm at {}, allowed are ends that meet to "
                           "{:.3g} mm, or a wider gap in the case, such as gap = \"{:.2g} mm\"",
                           1e3 * apart, in_mm(where), 1e3 * gap, 1.1e3 * apart));
}

/// A chain that grows at its end by the curves that are left.
class Chaining {
 public:
  Chaining(const CaseNode& file, Chain curves, double gap)
      : file_(file), left_(std::move(curves)), size_(size_of(left_)) {
    joined_ = tolerance::joined * size_;
    gap_ = std::max(gap, joined_);
  }

  Chained from(const Point& x) {
    double apart = HUGE_VAL;
    auto first = left_.begin();
    for (auto curve = left_.begin(); curve != left_.end(); ++curve)
      if (const double here = core::distance(*curve, x, apart); here < apart) apart = here, first = curve;
    chain_ = {*first};
    left_.erase(first);
    extend();
    chain_ = turned(chain_);
    extend();
    if (!branch_) refuse_end_near_rest();
    return {chain_, left_, closed_, branch_};
  }

 private:
  /// Distance of the nearer end of a curve from a place, m.
  static double distance(const Segment& curve, const Point& x) {
    return std::min((curve.start - x).norm(), (curve.end - x).norm());
  }

  Chain::iterator nearest_to(const Point& x) {
    auto nearest = left_.end();
    double least = HUGE_VAL;
    for (auto curve = left_.begin(); curve != left_.end(); ++curve) {
      const double square = std::min((curve->start - x).squaredNorm(), (curve->end - x).squaredNorm());
      if (square < least) least = square, nearest = curve;
    }
    return nearest;
  }

  /// Moves the curves that follow the chain's end, one after the other, from those left to it.
  void extend() {
    while (!is_closed_within(joined_)) {
      const Point end = chain_.back().end;
      const auto nearest = nearest_to(end);
      const double apart = nearest == left_.end() ? HUGE_VAL : distance(*nearest, end);
      if (apart <= joined_ && is_branch(end)) return branch_.emplace(end), void();
      if (is_closed_within(std::min(gap_, apart))) return close();
      if (apart > gap_) return;
      chain_.push_back((nearest->start - end).norm() <= (nearest->end - end).norm() ? *nearest : turned({*nearest})[0]);
      left_.erase(nearest);
      if (apart > joined_) note(apart, end), join(chain_[chain_.size() - 2], chain_.back());
    }
  }

  bool is_branch(const Point& end) const {
    const auto follows = [&](const Segment& s) { return distance(s, end) <= joined_; };
    return std::count_if(left_.begin(), left_.end(), follows) > 1;
  }

  bool is_closed_within(double gap) const {
    return chain_.size() > 1 && (chain_.front().start - chain_.back().end).norm() <= gap;
  }

  void close() {
    note((chain_.front().start - chain_.back().end).norm(), chain_.back().end);
    join(chain_.back(), chain_.front());
  }

  void note(double apart, const Point& where) {
    ++closed_.count;
    if (apart > closed_.widest) closed_.widest = apart, closed_.where = where;
  }

  /// Refuses a gap, where an end of the curves that are left over is near one of the chain.
  void refuse_end_near_rest() const {
    double nearest = std::numeric_limits<double>::infinity();
    Point where = Point::Zero();
    if (!is_closed_within(joined_))
      for (const Segment& segment : left_)
        for (const Point& end : {chain_.front().start, chain_.back().end})
          if (const double apart = distance(segment, end); apart < nearest) nearest = apart, where = end;
    if (nearest < tolerance::drawing_gap * size_) refuse_gap(file_, nearest, where, gap_);
  }

  const CaseNode& file_;
  Chain chain_, left_;
  ClosedGaps closed_;
  std::optional<Point> branch_;
  double size_, joined_ = 0, gap_ = 0;  ///< m
};

}  // namespace

Chain turned(const Chain& chain) {
  return core::reversed({chain, {}}).segments;
}

std::string in_mm(const Point& x) {
  return fmt::format("({:.6g}, {:.6g}) mm", 1e3 * x[0], 1e3 * x[1]);
}

bool is_closed(const Chain& chain) {
  return chain.size() > 1 && (chain.front().start - chain.back().end).norm() <= tolerance::joined * size_of(chain);
}

void refuse_nearly_closed(const CaseNode& file, const Chain& chain, double gap) {
  const double apart = (chain.front().start - chain.back().end).norm();
  if (chain.size() > 1 && apart < tolerance::drawing_gap * size_of(chain))
    refuse_gap(file, apart, chain.back().end, gap);
}

Chained chained(const CaseNode& file, Chain curves, const Point& from, double gap) {
  return Chaining(file, std::move(curves), gap).from(from);
}

void refuse_several(const CaseNode& file, const Chained& drawn, const std::string& why) {
  core::refuse(file,
               fmt::format("several outlines were found in the drawing, one with {} curves and {} more curves; {}",
                           drawn.chain.size(), drawn.rest.size(), why));
}

/// core::size takes the end of each segment for the start of another.
double size_of(Chain curves) {
  const Chain back = turned(curves);
  curves.insert(curves.end(), back.begin(), back.end());
  return core::size(core::Profile{std::move(curves), {}});
}

}  // namespace parison::forming
