// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <gmsh.h>

#include <array>
#include <cmath>
#include <filesystem>

#include "core/io/files.hpp"
#include "core/process/gmsh_session.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;
using Space = std::array<double, 3>;

constexpr double step_unit = 1e-3;  // what the reader of STEP files converts every file to, m

/// A curve as the CAD kernel has it, at three values of its parameter.
struct Curve {
  bool is_arc;
  Space start, mid, end;
};

Space place(int tag, double parameter) {
  std::vector<double> x;
  gmsh::model::getValue(1, tag, {parameter}, x);
  return {step_unit * x[0], step_unit * x[1], step_unit * x[2]};
}

/// A circle comes as two halves, so that every arc has two ends.
void add_curve(int tag, bool is_arc, std::vector<Curve>& curves) {
  std::vector<double> low, high;
  gmsh::model::getParametrizationBounds(1, tag, low, high);
  const int parts = is_arc && high[0] - low[0] > M_PI ? 2 : 1;
  for (int i = 0; i < parts; ++i) {
    const auto at = [&](double fraction) { return place(tag, low[0] + (i + fraction) / parts * (high[0] - low[0])); };
    curves.push_back({is_arc, at(0), at(0.5), at(1)});
  }
}

std::vector<Curve> read_curves(const CaseNode& file, const std::string& path) {
  gmsh::vectorpair found;
  gmsh::model::occ::importShapes(path, found, false, "step");
  gmsh::model::occ::synchronize();
  gmsh::model::getEntities(found, 3);
  if (!found.empty())
    core::refuse(file, fmt::format("\"{}\" contains a solid, allowed is a section: curves or a plane face", path));
  gmsh::model::getEntities(found, 1);
  if (found.empty())
    core::refuse(file, fmt::format("no curves were found in \"{}\", allowed is a STEP file with a section", path));
  std::vector<Curve> curves;
  for (const auto& [dimension, tag] : found) {
    std::string kind;
    gmsh::model::getType(dimension, tag, kind);
    if (kind != "Line" && kind != "Circle")
      core::refuse(
          file,
          fmt::format("\"{}\" contains a curve of type {}, allowed are lines and circular arcs (convert it in the CAD "
                      "program, or give its points as CSV)",
                      path, kind));
    add_curve(tag, kind == "Circle", curves);
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
  if (!std::filesystem::is_regular_file(path))
    core::refuse(file,
                 fmt::format("no file \"{}\", allowed is a drawing with its path relative to the case file", path));
  if (core::read_text(path).rfind("ISO-10303-21", 0) != 0)
    core::refuse(
        file,
        fmt::format("\"{}\" is no STEP file (its first line does not say ISO-10303-21), allowed is one with a section",
                    path));
  const core::GmshSession gmsh;
  const auto curves = read_curves(file, path);
  const auto [first, second] = find_plane(file, path, curves);
  std::vector<Segment> segments;
  for (const Curve& curve : curves) {
    const Point start(curve.start[first], curve.start[second]), end(curve.end[first], curve.end[second]);
    if (curve.is_arc) {
      segments.push_back(arc_through(start, {curve.mid[first], curve.mid[second]}, end));
    } else {
      segments.emplace_back();
      segments.back().start = start;
      segments.back().end = end;
    }
  }
  return segments;
}

}  // namespace parison::forming
