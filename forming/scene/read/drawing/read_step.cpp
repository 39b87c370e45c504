// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <gmsh.h>

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/case/given_file.hpp"
#include "core/process/child_work.hpp"
#include "core/process/gmsh_session.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;
using Space = std::array<double, 3>;

constexpr double step_unit = 1e-3;  // what the reader of STEP files converts every file to, m

/// A curve as the CAD kernel has it, at three values of its parameter; of a part of a spline and the like also the
/// derivatives at its ends, with respect to a parameter from 0 to 1.
struct Curve {
  enum class Kind { line, arc, part } kind;
  Space start, mid, end;
  Space start_rate{}, end_rate{};
};
constexpr std::array kinds{"line", "arc", "part"};

Space place(int tag, double parameter) {
  std::vector<double> x;
  gmsh::model::getValue(1, tag, {parameter}, x);
  return {step_unit * x[0], step_unit * x[1], step_unit * x[2]};
}

Space rate(int tag, double parameter, double scale) {
  std::vector<double> derivative;
  gmsh::model::getDerivative(1, tag, {parameter}, derivative);
  return {scale * step_unit * derivative[0], scale * step_unit * derivative[1], scale * step_unit * derivative[2]};
}

/// A circle comes as two halves, so that every arc has two ends; splines and other curves come in parts so short that
/// cubics stand for them.
void add_curve(int tag, const std::string& type, std::vector<Curve>& curves) {
  constexpr int cubics = 64;
  const auto kind = type == "Line" ? Curve::Kind::line : type == "Circle" ? Curve::Kind::arc : Curve::Kind::part;
  std::vector<double> low, high;
  gmsh::model::getParametrizationBounds(1, tag, low, high);
  const double range = high[0] - low[0];
  const int parts = kind == Curve::Kind::part ? cubics : kind == Curve::Kind::arc && range > M_PI ? 2 : 1;
  for (int i = 0; i < parts; ++i) {
    const auto at = [&](double fraction) { return low[0] + (i + fraction) / parts * range; };
    curves.push_back({kind, place(tag, at(0)), place(tag, at(0.5)), place(tag, at(1))});
    if (kind != Curve::Kind::part) continue;
    curves.back().start_rate = rate(tag, at(0), range / parts);
    curves.back().end_rate = rate(tag, at(1), range / parts);
  }
}

/// What the CAD kernel finds in a file, as text: a line "refuse ..." or a line for each curve, its kind and fifteen
/// coordinates in m.
std::string text_of_curves(const std::string& path) {
  gmsh::vectorpair found;
  gmsh::model::occ::importShapes(path, found, false, "step");
  gmsh::model::occ::synchronize();
  gmsh::model::getEntities(found, 3);
  if (!found.empty())
    return fmt::format("refuse \"{}\" contains a solid, allowed is a section: curves or a plane face", path);
  gmsh::model::getEntities(found, 1);
  if (found.empty())
    return fmt::format("refuse no curves were found in \"{}\", allowed is a STEP file with a section", path);
  if (found.size() > max_segments)
    return fmt::format("refuse {} curves were found in \"{}\", allowed are up to {}", found.size(), path, max_segments);
  std::vector<Curve> curves;
  for (const auto& [dimension, tag] : found) {
    std::string kind;
    gmsh::model::getType(dimension, tag, kind);
    add_curve(tag, kind, curves);
  }
  std::string text;
  for (const Curve& curve : curves) {
    text += kinds[static_cast<std::size_t>(curve.kind)];
    for (const Space& x : {curve.start, curve.mid, curve.end, curve.start_rate, curve.end_rate})
      text += fmt::format(" {} {} {}", x[0], x[1], x[2]);
    text += '\n';
  }
  return text;
}

/// A line of `text_of_curves`; false where a coordinate is missing or not finite.
bool parse_curve(std::string_view line, Curve& curve) {
  const auto blank = std::min(line.find(' '), line.size());
  const auto kind = std::find(kinds.begin(), kinds.end(), line.substr(0, blank)) - kinds.begin();
  if (kind == static_cast<std::ptrdiff_t>(kinds.size())) return false;
  curve.kind = static_cast<Curve::Kind>(kind);
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
std::vector<Curve> read_curves(const CaseNode& file, const std::string& path) {
  const core::GmshSession gmsh;
  const core::ChildWork work = core::in_child([&] { return text_of_curves(path); });
  if (!work.death.empty())
    core::refuse(file, fmt::format("\"{}\" cannot be read by the CAD kernel ({}), allowed is a whole STEP file with a "
                                   "section",
                                   path, work.death));
  const std::string_view refusal = "refuse ";
  if (work.text.rfind(refusal, 0) == 0) core::refuse(file, work.text.substr(refusal.size()));
  std::vector<Curve> curves;
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
std::array<int, 2> find_plane(const CaseNode& file, const std::string& path, const std::vector<Curve>& curves) {
  Space away{}, low = curves.front().start, high = low;
  for (const Curve& curve : curves)
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
  const auto [first, second] = find_plane(file, path, curves);
  const auto flat = [first = first, second = second](const Space& x) { return Point(x[first], x[second]); };
  double size = 0;
  for (const Curve& curve : curves) size = std::max(size, (flat(curve.end) - flat(curves.front().start)).norm());
  std::vector<Segment> segments;
  for (const Curve& curve : curves) {
    const Point start = flat(curve.start), end = flat(curve.end);
    if (curve.kind == Curve::Kind::part) {
      const auto part =
          arcs_of(cubic({start, flat(curve.start_rate)}, {end, flat(curve.end_rate)}), 0, 1, tolerance::curve * size);
      segments.insert(segments.end(), part.begin(), part.end());
    } else if (curve.kind == Curve::Kind::arc) {
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
