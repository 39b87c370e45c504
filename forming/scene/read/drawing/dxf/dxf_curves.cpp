// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/dxf/dxf_curves.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::Point;
using core::Segment;

constexpr double max_bulge = 1e6;  ///< a circle but for a gap of 1e-6 of its radius

const char* article(const DxfEntity& entity) {
  return std::string("AEI").find(entity.kind.front()) == std::string::npos ? "a" : "an";
}

/// The side of a polyline as an arc; a line where it leaves the line by no more than `straight`, m.
Segment bent(const Segment& side, double bulge, double straight) {
  const Point along = side.end - side.start, left(-along[1], along[0]);
  if (std::abs(bulge) * along.norm() / 2 <= straight) return side;
  Segment arc = side;
  arc.is_arc = true;
  arc.centre = 0.5 * (side.start + side.end) + (1 - bulge * bulge) / (4 * bulge) * left;
  arc.radius = (side.start - arc.centre).norm();
  arc.from = std::atan2(side.start[1] - arc.centre[1], side.start[0] - arc.centre[0]);
  arc.to = arc.from + 4 * std::atan(bulge);
  return arc;
}

}  // namespace

void DxfCurves::add(const DxfEntity& entity) {
  require_flat(entity);
  const std::size_t first = curves_.size();
  if (entity.kind == "LINE")
    add_line(point(entity, 10, 20), point(entity, 11, 21));
  else if (entity.kind == "ARC")
    add_arc(entity, number(entity, 50), sweep_of(file_, entity, number(entity, 50), number(entity, 51), 360));
  else if (entity.kind == "CIRCLE")
    add_arc(entity, 0, 360);
  else if (entity.kind == "ELLIPSE")
    add_all(dxf_ellipse(file_, entity, unit));
  else if (entity.kind == "SPLINE")
    add_all(dxf_spline(file_, entity, unit));
  else if (entity.kind == "LWPOLYLINE")
    begin_polyline(entity), add_light_vertices(entity), end_polyline(entity);
  else if (entity.kind == "POLYLINE")
    begin_polyline(entity);
  else if (entity.kind == "VERTEX")
    vertices_.push_back({point(entity, 10, 20), number(entity, 42, 0)});
  else if (entity.kind == "SEQEND")
    end_polyline(entity);
  else
    refuse(entity, fmt::format("{} {} was found, allowed are LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and "
                               "POLYLINE (explode or convert "
                               "it in the CAD program, or choose a layer without it)",
                               article(entity), entity.kind));
  if (entity.kind == "ARC" || entity.kind == "CIRCLE") turn_to_front(entity, first);
}

void DxfCurves::require_flat(const DxfEntity& entity) const {
  constexpr double flat = 1e-4;  // slope that changes a length by 5e-9
  const bool is_line = entity.kind == "LINE", is_ellipse = entity.kind == "ELLIPSE";
  const bool has_own_plane = !is_line && entity.kind != "SPLINE";  // the others have all three coordinates
  const double across = has_own_plane ? std::max(spread(entity, {210}, true), spread(entity, {220}, true)) : 0.0;
  const std::vector<std::vector<int>> heights =
      is_line ? std::vector<std::vector<int>>{{30, 31}} : std::vector<std::vector<int>>{{30}, {31}};
  double rise = 0, extent = 0;
  for (const auto& codes : heights) rise = std::max(rise, spread(entity, codes, is_ellipse && codes.front() == 31));
  for (const int code : {10, 11, 20, 21}) extent = std::max(extent, spread(entity, {code}, true));
  if (across > flat || rise > flat * extent)
    refuse(entity, fmt::format("{} {} that is not parallel to the plane of x and y was found, allowed is a section "
                               "drawn in that plane",
                               article(entity), entity.kind));
}

void DxfCurves::place(std::size_t first, const Placement& placement) {
  for (std::size_t i = first; i < curves_.size(); ++i) {
    curves_[i] = placement(curves_[i]);
    if (placement.mirrored) bulges_[i] = -bulges_[i];
  }
}

void DxfCurves::turn_to_front(const DxfEntity& entity, std::size_t first) {
  if (number(entity, 230, 1) >= 0) return;
  Placement reflection;
  reflection.mirrored = true;
  place(first, reflection);
}

void DxfCurves::require_end_of_polyline() const {
  if (open_) refuse(*open_, "a POLYLINE without SEQEND was found, allowed is one with it");
}

std::vector<Segment> DxfCurves::all() const {
  std::vector<Segment> curves = curves_;
  const double straight = tolerance::joined * size_of(curves);
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (bulges_[i] != 0) curves[i] = bent(curves[i], bulges_[i], straight);
  return curves;
}

void DxfCurves::refuse(const DxfEntity& entity, const std::string& message) const {
  file_.refuse(entity.line, message);
}

double DxfCurves::number(const DxfEntity& entity, int code, double otherwise) const {
  for (const DxfGroup& group : entity.groups)
    if (group.code == code) return file_.number(group);
  if (std::isnan(otherwise))
    refuse(entity,
           fmt::format("{} {} without group {} was found, allowed is one with it", article(entity), entity.kind, code));
  return otherwise;
}

double DxfCurves::spread(const DxfEntity& entity, const std::vector<int>& codes, bool from_zero) const {
  std::vector<double> values(from_zero, 0.0);
  for (const DxfGroup& group : entity.groups)
    if (std::count(codes.begin(), codes.end(), group.code)) values.push_back(file_.number(group));
  if (values.empty()) return 0;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

Point DxfCurves::point(const DxfEntity& entity, int x, int y) const {
  return unit * Point(number(entity, x), number(entity, y));
}

void DxfCurves::add_curve(const Segment& curve, double bulge) {
  curves_.push_back(curve);
  curves_.back().boundary_id = layer;
  bulges_.push_back(bulge);
  if (curves_.size() > max_segments)
    core::refuse(file_.node, fmt::format("more than {} curves were found in \"{}\", allowed are so many", max_segments,
                                         file_.path));
}

void DxfCurves::add_all(const std::vector<Segment>& arcs) {
  for (const Segment& arc : arcs) add_curve(arc, 0);
}

void DxfCurves::add_line(const Point& start, const Point& end, double bulge) {
  Segment line;
  line.start = start;
  line.end = end;
  add_curve(line, bulge);
}

/// Counterclockwise, angles in degrees; what is nearly a whole circle as two halves, so that it has ends that meet.
void DxfCurves::add_arc(const DxfEntity& entity, double from, double sweep) {
  constexpr double nearly_whole = 359;
  Segment arc;
  arc.is_arc = true;
  arc.centre = point(entity, 10, 20);
  arc.radius = unit * number(entity, 40);
  if (!(arc.radius > 0))
    refuse(entity,
           fmt::format("{} {} without a radius was found, allowed are radii above zero", article(entity), entity.kind));
  const int parts = sweep > nearly_whole ? 2 : 1;
  for (int i = 0; i < parts; ++i) {
    arc.from = (from + sweep * i / parts) * M_PI / 180;
    arc.to = (from + sweep * (i + 1) / parts) * M_PI / 180;
    arc.start = arc.centre + arc.radius * Point(std::cos(arc.from), std::sin(arc.from));
    arc.end = arc.centre + arc.radius * Point(std::cos(arc.to), std::sin(arc.to));
    add_curve(arc, 0);
  }
}

/// The bulge is the tangent of a quarter of the angle that the arc turns.
void DxfCurves::add_bulge(const DxfEntity& entity, const Vertex& from, const Point& end) {
  if (!(std::abs(from.bulge) <= max_bulge))
    refuse(entity,
           fmt::format("a bulge of {:g} was found, allowed are bulges of up to {:g} in size", from.bulge, max_bulge));
  if (!std::isfinite(from.x[1]) || !std::isfinite(end[1]))
    refuse(entity, "a vertex without group 20 was found, allowed are vertices with it");
  add_line(from.x, end, from.bulge);
}

void DxfCurves::begin_polyline(const DxfEntity& entity) {
  const double flags = number(entity, 70, 0);
  constexpr double closed = 1, line_pattern = 128;
  closed_ = flags == closed || flags == closed + line_pattern;
  if (!closed_ && flags != 0 && flags != line_pattern)
    refuse(entity,
           fmt::format("a curve-fitted or three-dimensional {} was found, allowed is a plane one of lines and arcs",
                       entity.kind));
  require_end_of_polyline();
  open_ = entity;
}

void DxfCurves::add_light_vertices(const DxfEntity& entity) {
  for (const DxfGroup& group : entity.groups) {
    if (group.code == 10) vertices_.push_back({{unit * file_.number(group), std::nan("")}, 0});
    if (vertices_.empty()) continue;
    if (group.code == 20) vertices_.back().x[1] = unit * file_.number(group);
    if (group.code == 42) vertices_.back().bulge = file_.number(group);
  }
  const double count = number(entity, 90, double(vertices_.size()));
  if (count != double(vertices_.size()))
    refuse(entity, fmt::format("{} vertices were found, the entity says {}", vertices_.size(), count));
}

void DxfCurves::end_polyline(const DxfEntity& entity) {
  const std::size_t first = curves_.size();
  for (std::size_t i = 1; i < vertices_.size(); ++i) add_bulge(entity, vertices_[i - 1], vertices_[i].x);
  if (closed_ && vertices_.size() > 1) add_bulge(entity, vertices_.back(), vertices_.front().x);
  if (open_) turn_to_front(*open_, first);
  vertices_.clear();
  open_.reset();
}

}  // namespace parison::forming
