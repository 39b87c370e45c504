// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/case/given_file.hpp"
#include "core/process/child_work.hpp"
#include "core/process/gmsh_module.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/drawing/step_curves.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;

/// A line of what the CAD kernel finds; false where a coordinate is missing or not finite.
bool parse_curve(std::string_view line, StepCurve& curve) {
  const auto blank = std::min(line.find(' '), line.size());
  const auto kind =
      std::find(step_curve_kinds.begin(), step_curve_kinds.end(), line.substr(0, blank)) - step_curve_kinds.begin();
  if (kind == static_cast<std::ptrdiff_t>(step_curve_kinds.size())) return false;
  curve.kind = static_cast<StepCurve::Kind>(kind);
  line.remove_prefix(blank);
  for (Space* x : {&curve.start, &curve.mid, &curve.end, &curve.start_rate, &curve.end_rate})
    for (double& component : *x) {
      if (line.empty()) return false;
      const auto read = std::from_chars(line.data() + 1, line.data() + line.size(), component);
      if (read.ec != std::errc{} || !std::isfinite(component)) return false;
      line.remove_prefix(static_cast<std::size_t>(read.ptr - line.data()));
    }
  return line.empty();
}

/// The CAD kernel crashes on some damaged files, so it works in a process of its own.
std::vector<StepCurve> read_curves(const CaseNode& file, const std::string& path) {
  static auto& find = core::gmsh_function<decltype(parison_find_curves)>("parison_find_curves");
  core::ChildWork work;
  const auto text_of_curves = [&] {
    std::string text;
    find(path, text);
    return text;
  };
  core::in_gmsh_session([&] { work = core::in_child(text_of_curves); });
  if (!work.death.empty())
    core::refuse(file, fmt::format("\"{}\" cannot be read by the CAD kernel ({}), allowed is a whole STEP file with a "
                                   "section",
                                   path, work.death));
  const std::string_view refusal = "refuse ";
  if (work.text.rfind(refusal, 0) == 0) core::refuse(file, work.text.substr(refusal.size()));
  std::vector<StepCurve> curves;
  core::Lines lines(work.text);
  for (std::string_view line; lines.next(line);) {
    curves.emplace_back();
    if (!parse_curve(line, curves.back()))
      core::refuse(
          file, fmt::format("\"{}\" contains a curve whose place is no number, allowed are finite coordinates", path));
  }
  return curves;
}

/// The two axes of the coordinate plane through the origin that contains all curves: (x, y), (x, z) or (y, z).
std::array<int, 2> find_plane(const CaseNode& file, const std::string& path, const std::vector<StepCurve>& curves) {
  Space away{}, low = curves.front().start, high = low;
  for (const StepCurve& curve : curves)
    for (const Space& x : {curve.start, curve.mid, curve.end})
      for (int k = 0; k < 3; ++k) {
        away[k] = std::max(away[k], std::abs(x[k]));
        low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
      }
  const double in_plane = tolerance::joined * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (away[2] < in_plane) return {0, 1};
  if (away[1] < in_plane) return {0, 2};
  if (away[0] < in_plane) return {1, 2};
  core::refuse(
      file,
      fmt::format("the curves of \"{}\" lie in no coordinate plane, allowed are x and y, x and z, or y and z", path));
}

Segment arc_through(const Point& start, const Point& mid, const Point& end) {
  const Point a = mid - start, b = end - start;
  const double turn = a[0] * b[1] - a[1] * b[0];  // positive counterclockwise
  Segment arc;
  arc.is_arc = true;
  arc.start = start;
  arc.end = end;
  arc.centre =
      start + Point(b[1] * a.squaredNorm() - a[1] * b.squaredNorm(), a[0] * b.squaredNorm() - b[0] * a.squaredNorm()) /
                  (2 * turn);
  arc.radius = (start - arc.centre).norm();
  arc.from = std::atan2(start[1] - arc.centre[1], start[0] - arc.centre[0]);
  arc.to = std::atan2(end[1] - arc.centre[1], end[0] - arc.centre[0]);
  if (turn > 0 && arc.to <= arc.from) arc.to += 2 * M_PI;
  if (turn < 0 && arc.to >= arc.from) arc.to -= 2 * M_PI;
  return arc;
}

}  // namespace

std::vector<Segment> read_step(const CaseNode& file, const std::string& path) {
  const std::string content = core::read_given_file(file, path, "a drawing with its path relative to the case file");
  if (content.rfind("ISO-10303-21", 0) != 0)
    core::refuse(
        file,
        fmt::format("\"{}\" is no STEP file (its first line does not say ISO-10303-21), allowed is one with a section",
                    path));
  if (content.find("END-ISO-10303-21") == content.npos)
    core::refuse(file,
                 fmt::format("\"{}\" ends without END-ISO-10303-21, so a part of it is missing, allowed is a whole "
                             "STEP file",
                             path));
  const auto curves = read_curves(file, path);
  if (core::read_given_file(file, path, "a drawing") != content)  // the kernel has read it once more
    core::refuse(file,
                 fmt::format("\"{}\" has changed while it was read, allowed is a file that stays as it is", path));
  const auto [first, second] = find_plane(file, path, curves);
  const auto flat = [first = first, second = second](const Space& x) { return Point(x[first], x[second]); };
  double size = 0;
  for (const StepCurve& curve : curves) size = std::max(size, (flat(curve.end) - flat(curves.front().start)).norm());
  std::vector<Segment> segments;
  for (const StepCurve& curve : curves) {
    const Point start = flat(curve.start), end = flat(curve.end);
    if (curve.kind == StepCurve::Kind::part) {
      const auto part =
          arcs_of(cubic({start, flat(curve.start_rate)}, {end, flat(curve.end_rate)}), 0, 1, tolerance::curve * size);
      segments.insert(segments.end(), part.begin(), part.end());
    } else if (curve.kind == StepCurve::Kind::arc) {
      segments.push_back(arc_through(start, flat(curve.mid), end));
    } else {
      segments.emplace_back();
      segments.back().start = start;
      segments.back().end = end;
    }
  }
  if (segments.size() > max_segments)
    core::refuse(
        file, fmt::format("\"{}\" gives {} lines and arcs, allowed are up to {}", path, segments.size(), max_segments));
  return segments;
}

}  // namespace parison::forming
