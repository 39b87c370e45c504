// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cavities/outline_walk.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace parison::forming {

namespace {

constexpr int max_chords = 20000;  ///< of one walk
constexpr double same_place = 1e-9;

/// What a walk meets on a chord, at the fraction t of it.
struct Event {
  double t = std::numeric_limits<double>::infinity();
  enum class Kind { none, target, other_tool } kind = Kind::none;
  Index arc = -1;
  OutlinePlace place{};  ///< on the other tool
};

/// What a walk along a symmetry line comes to first: glass, a tool, or the corner with another symmetry line.
struct LineEnd {
  double ahead = std::numeric_limits<double>::infinity();  ///< m
  Index arc = -1, run = -1;                                ///< of the glass, of a tool; neither at a corner
  Point point = Point::Zero();
  std::optional<Point> turned;  ///< direction in which the walk leaves a corner
};

class Walker {
 public:
  Walker(const WalkScene& scene, Index from_node)
      : scene_(scene), runs_(scene.outlines.runs), from_node_(from_node), near_(runs_.size(), false) {}

  Walk along_tools(const OutlinePlace& from);
  Walk along_line(const Point& from, const Point& direction);

 private:
  bool advance();
  bool follow_line(Point from, Point direction);
  LineEnd end_of_line(const Point& from, const Point& direction) const;
  bool finish_chord();
  Event first_event() const;
  void meet_targets(Event& first) const;
  void meet_crossings(Index run, Event& first) const;
  void meet_start(Index run, Event& first) const;
  std::optional<OutlinePlace> closest_other_run(const Point& x);
  void go_to(const OutlinePlace& place);
  void add(Index tool, const Point& to);
  Index tool() const { return runs_[at_.run].tool; }
  Point chord_start() const { return runs_[at_.run].points[at_.chord]; }
  Point chord_end() const { return runs_[at_.run].points[at_.chord + 1]; }

  const WalkScene& scene_;
  const std::vector<OutlineRun>& runs_;
  Index from_node_;
  OutlinePlace at_{};
  Point here_ = Point::Zero();
  std::vector<bool> near_;  ///< runs that have been next to the present one since the walk joined it
  Walk walk_;
};

void Walker::add(Index tool, const Point& to) {
  if (to != here_) walk_.pieces.push_back({tool, here_, to});
  here_ = to;
}

/// Changes over to another run, which begins next to the present one.
void Walker::go_to(const OutlinePlace& place) {
  const Index left = at_.run;
  add(-1, scene_.outlines.point(place));
  at_ = place;
  near_.assign(runs_.size(), false);
  near_[left] = true;
}

void Walker::meet_targets(Event& first) const {
  for (const auto& target : scene_.targets) {
    const bool ahead = target.place.run == at_.run && target.place.chord == at_.chord &&
                       target.place.t >= at_.t - same_place && target.place.t < first.t;
    if (ahead && target.node != from_node_) first = {target.place.t, Event::Kind::target, target.arc, {}};
  }
}

/// Chords of another run into which the present chord enters.
void Walker::meet_crossings(Index run, Event& first) const {
  const Point a = chord_start(), along = chord_end() - a;
  const auto& points = runs_[run].points;
  for (Index c = 0; c < runs_[run].chord_count(); ++c) {
    const Point other = points[c + 1] - points[c], offset = points[c] - a;
    const double turn = core::cross(along, other);
    // Into the body on the left of `other`.
    if (!(turn < -1e-12 * along.norm() * other.norm())) continue;
    const double t = core::cross(offset, other) / turn, s = core::cross(offset, along) / turn;
    if (s < -same_place || s >= 1 || t <= at_.t + same_place || t > 1 || t >= first.t) continue;
    first = {t, Event::Kind::other_tool, -1, {run, c, std::max(0.0, s)}};
  }
}

/// The start of another run next to the present chord.
void Walker::meet_start(Index run, Event& first) const {
  if (runs_[run].closed || near_[run]) return;
  const Point a = chord_start(), along = chord_end() - a, start = runs_[run].points.front();
  const double t = (start - a).dot(along) / along.squaredNorm();
  if (t <= at_.t + same_place || t > 1 || t >= first.t) return;
  if ((a + t * along - start).norm() <= scene_.seal_gap) first = {t, Event::Kind::other_tool, -1, {run, 0, 0}};
}

Event Walker::first_event() const {
  Event first;
  for (Index run = 0; run < static_cast<Index>(runs_.size()); ++run) {
    if (runs_[run].tool == tool()) continue;
    meet_crossings(run, first);
    meet_start(run, first);
  }
  meet_targets(first);
  return first;
}

/// The nearest place of another tool within the gap that seals. Runs that have been that near since the walk joined the
/// present one do not count until they have been farther away.
std::optional<OutlinePlace> Walker::closest_other_run(const Point& x) {
  std::optional<OutlinePlace> closest;
  double least = scene_.seal_gap;
  for (Index run = 0; run < static_cast<Index>(runs_.size()); ++run) {
    if (runs_[run].tool == tool()) continue;
    const auto nearest = scene_.outlines.nearest(run, x);
    if (nearest.distance > scene_.seal_gap) near_[run] = false;
    if (near_[run] || nearest.distance > least) continue;
    least = nearest.distance;
    closest = nearest.place;
  }
  return closest;
}

/// Passes on from the end of the present chord; false where the walk is over.
bool Walker::finish_chord() {
  const OutlineRun& run = runs_[at_.run];
  const bool at_end = at_.chord + 1 == run.chord_count() && !run.closed;
  if (at_end && run.open_line_after) return follow_line(here_, *run.open_line_after);
  if (at_end) near_.assign(runs_.size(), false);
  if (const auto other = closest_other_run(here_)) {
    const auto& points = runs_[other->run].points;
    const bool leads_on =
        other->chord + 1 < static_cast<Index>(points.size()) - 1 || other->t < 1 || runs_[other->run].open_line_after;
    if (leads_on || !at_end) {
      go_to(*other);
      return true;
    }
  }
  if (at_end) return false;
  at_ = {at_.run, (at_.chord + 1) % run.chord_count(), 0};
  return true;
}

bool Walker::advance() {
  const Event event = first_event();
  if (event.kind == Event::Kind::none) {
    add(tool(), chord_end());
    return finish_chord();
  }
  add(tool(), chord_start() + event.t * (chord_end() - chord_start()));
  if (event.kind == Event::Kind::target) {
    walk_.arc = event.arc;
    return false;
  }
  go_to(event.place);
  return true;
}

/// What lies ahead on the line, and lines with a body on them that cross it on the side of the gap.
LineEnd Walker::end_of_line(const Point& from, const Point& direction) const {
  constexpr double opposite = -0.99, crossing = 0.1;  // of unit directions: product, cross product
  LineEnd first;
  const auto meet = [&](const Point& x, const Point& line, Index arc, Index run) {
    const Point to = x - from;
    const double turn = core::cross(direction, line);
    const bool is_same_line = line.dot(direction) < opposite;
    if (!is_same_line && turn < crossing) return;
    const double ahead = is_same_line ? to.dot(direction) : core::cross(to, line) / turn;
    const double off = is_same_line ? -std::abs(core::cross(to, direction)) : core::cross(to, direction) / turn;
    if (off < -scene_.seal_gap || ahead <= -scene_.seal_gap || ahead >= first.ahead) return;
    if (is_same_line)
      first = {ahead, arc, run, x, {}};
    else
      first = {ahead, -1, -1, from + ahead * direction, -line};
  };
  for (const auto& target : scene_.line_targets) meet(target.point, target.direction, target.arc, -1);
  for (Index run = 0; run < static_cast<Index>(runs_.size()); ++run)
    if (runs_[run].open_line_before) meet(runs_[run].points.front(), *runs_[run].open_line_before, -1, run);
  return first;
}

/// Goes on with the next body on the symmetry line, or on the one that it meets at a corner; false where it is the
/// glass, or where there is none.
bool Walker::follow_line(Point from, Point direction) {
  constexpr int most_corners = 8;
  here_ = from;
  for (int corner = 0; corner <= most_corners; ++corner) {
    const LineEnd end = end_of_line(from, direction);
    if (end.run >= 0) {
      go_to({end.run, 0, 0});
      near_.assign(runs_.size(), false);
      return true;
    }
    if (end.arc >= 0 || end.turned) add(-1, end.point);
    walk_.arc = end.arc;
    if (!end.turned) return false;
    from = end.point;
    direction = *end.turned;
  }
  return false;
}

Walk Walker::along_tools(const OutlinePlace& from) {
  at_ = from;
  here_ = scene_.outlines.point(from);
  int steps = 0;
  while (advance())
    if (++steps > max_chords) return {};
  return std::move(walk_);
}

Walk Walker::along_line(const Point& from, const Point& direction) {
  here_ = from;
  if (!follow_line(from, direction)) return std::move(walk_);
  int steps = 0;
  while (advance())
    if (++steps > max_chords) return {};
  return std::move(walk_);
}

}  // namespace

Walk walk_outlines(const WalkScene& scene, const OutlinePlace& from, Index from_node) {
  return Walker(scene, from_node).along_tools(from);
}

Walk walk_line(const WalkScene& scene, const Point& from, const Point& direction) {
  return Walker(scene, -1).along_line(from, direction);
}

}  // namespace parison::forming
