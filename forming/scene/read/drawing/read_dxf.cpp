// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/case/given_file.hpp"
#include "forming/scene/read/drawing/dxf_blocks.hpp"
#include "forming/scene/read/drawing/dxf_curve.hpp"
#include "forming/scene/read/drawing/dxf_file.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;
using Entity = DxfEntity;
using Group = DxfGroup;

constexpr double max_bulge = 1e6;  ///< a circle but for a gap of 1e-6 of its radius

/// The curves of the wanted entities, one entity after the other.
class DxfCurves {
 public:
  DxfCurves(const DxfFile& file, double unit) : file_(file), unit_(unit) {}

  void add(const Entity& entity) {
    require_flat(entity);
    if (entity.kind == "LINE")
      add_line(point(entity, 10, 20), point(entity, 11, 21));
    else if (entity.kind == "ARC")
      add_arc(entity, number(entity, 50), number(entity, 51));
    else if (entity.kind == "CIRCLE")
      add_arc(entity, 0, 180), add_arc(entity, 180, 360);
    else if (entity.kind == "ELLIPSE")
      add_all(dxf_ellipse(file_, entity, unit_));
    else if (entity.kind == "SPLINE")
      add_all(dxf_spline(file_, entity, unit_));
    else if (entity.kind == "LWPOLYLINE")
      begin_polyline(entity), add_light_vertices(entity), end_polyline(entity);
    else if (entity.kind == "POLYLINE")
      begin_polyline(entity);
    else if (entity.kind == "VERTEX")
      add_vertex(point(entity, 10, 20), number(entity, 42, 0));
    else if (entity.kind == "SEQEND")
      end_polyline(entity);
    else
      refuse(entity, fmt::format("a {} was found, allowed are LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE and "
                                 "POLYLINE (explode or convert "
                                 "it in the CAD program, or choose a layer without it)",
                                 entity.kind));
  }

  /// Refuses what is seen from behind, and what is not parallel to the plane of x and y: its shape would be that of its
  /// shadow.
  void require_flat(const Entity& entity) const {
    constexpr double flat = 1e-4;  // slope that changes a length by 5e-9
    if (number(entity, 230, 1) < 0)
      refuse(entity, fmt::format("{} {} with a negative extrusion direction (seen from behind) was found, allowed is a "
                                 "positive one",
                                 article(entity), entity.kind));
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

  /// Moves the curves from one on as a block is inserted.
  void place(std::size_t first, const DxfPlacement& placement) {
    for (std::size_t i = first; i < curves.size(); ++i) {
      curves[i] = placement(curves[i]);
      if (placement.mirrored) bulges[i] = -bulges[i];
    }
  }

  /// Refuses a polyline whose end has not been read.
  void require_end_of_polyline() const {
    if (open_) refuse(*open_, "a POLYLINE without SEQEND was found, allowed is one with it");
  }

  std::vector<Segment> curves;
  std::vector<double> bulges;  ///< of the curves: 0 but for bent sides of polylines, which are still lines

 private:
  struct Vertex {
    Point x;
    double bulge;
  };

  static const char* article(const Entity& entity) {
    return std::string("AEI").find(entity.kind.front()) == std::string::npos ? "a" : "an";
  }

  [[noreturn]] void refuse(const Entity& entity, const std::string& message) const {
    file_.refuse(entity.line, message);
  }

  double number(const Entity& entity, int code, double otherwise = std::nan("")) const {
    for (const Group& group : entity.groups)
      if (group.code == code) return file_.number(group);
    if (std::isnan(otherwise))
      refuse(entity, fmt::format("a {} without group {} was found, allowed is one with it", entity.kind, code));
    return otherwise;
  }

  /// The largest difference between the values of some groups of an entity, of one of them also from 0.
  double spread(const Entity& entity, const std::vector<int>& codes, bool from_zero = false) const {
    std::vector<double> values(from_zero, 0.0);
    for (const Group& group : entity.groups)
      if (std::count(codes.begin(), codes.end(), group.code)) values.push_back(file_.number(group));
    if (values.empty()) return 0;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high - *low;
  }

  Point point(const Entity& entity, int x, int y) const { return unit_ * Point(number(entity, x), number(entity, y)); }

  void add(const Segment& curve, double bulge) {
    curves.push_back(curve);
    bulges.push_back(bulge);
    if (curves.size() > max_segments)
      core::refuse(file_.node, fmt::format("more than {} curves were found in \"{}\", allowed are so many",
                                           max_segments, file_.path));
  }

  void add_all(const std::vector<Segment>& arcs) {
    for (const Segment& arc : arcs) add(arc, 0);
  }

  void add_line(const Point& start, const Point& end, double bulge = 0) {
    Segment line;
    line.start = start;
    line.end = end;
    add(line, bulge);
  }

  /// Counterclockwise between two angles in degrees.
  void add_arc(const Entity& entity, double from, double to) {
    Segment arc;
    arc.is_arc = true;
    arc.centre = point(entity, 10, 20);
    arc.radius = unit_ * number(entity, 40);
    if (!(arc.radius > 0))
      refuse(entity, fmt::format("an {} without a radius was found, allowed are radii above zero", entity.kind));
    if (std::abs(from) > 360 || std::abs(to) > 360 || to - from > 360)
      refuse(entity, fmt::format("an {} from {:g} to {:g} degrees was found, allowed is up to one turn", entity.kind,
                                 from, to));
    arc.from = from * M_PI / 180;
    arc.to = (to > from ? to : to + 360) * M_PI / 180;
    arc.start = arc.centre + arc.radius * Point(std::cos(arc.from), std::sin(arc.from));
    arc.end = arc.centre + arc.radius * Point(std::cos(arc.to), std::sin(arc.to));
    add(arc, 0);
  }

  /// The bulge is the tangent of a quarter of the angle that the arc turns.
  void add_bulge(const Entity& entity, const Vertex& from, const Point& end) {
    if (!(std::abs(from.bulge) <= max_bulge))
      refuse(entity,
             fmt::format("a bulge of {:g} was found, allowed are bulges of up to {:g} in size", from.bulge, max_bulge));
    if (!std::isfinite(from.x[1]) || !std::isfinite(end[1]))
      refuse(entity, "a vertex without group 20 was found, allowed are vertices with it");
    add_line(from.x, end, from.bulge);
  }

  void begin_polyline(const Entity& entity) {
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

  void add_vertex(const Point& x, double bulge) { vertices_.push_back({x, bulge}); }

  void add_light_vertices(const Entity& entity) {
    for (const Group& group : entity.groups) {
      if (group.code == 10) add_vertex({unit_ * file_.number(group), std::nan("")}, 0);
      if (vertices_.empty()) continue;
      if (group.code == 20) vertices_.back().x[1] = unit_ * file_.number(group);
      if (group.code == 42) vertices_.back().bulge = file_.number(group);
    }
    const double count = number(entity, 90, double(vertices_.size()));
    if (count != double(vertices_.size()))
      refuse(entity, fmt::format("{} vertices were found, the entity says {}", vertices_.size(), count));
  }

  void end_polyline(const Entity& entity) {
    for (std::size_t i = 1; i < vertices_.size(); ++i) add_bulge(entity, vertices_[i - 1], vertices_[i].x);
    if (closed_ && vertices_.size() > 1) add_bulge(entity, vertices_.back(), vertices_.front().x);
    vertices_.clear();
    open_.reset();
  }

  const DxfFile& file_;
  double unit_;
  std::vector<Vertex> vertices_;  ///< of the polyline being read
  std::optional<Entity> open_;    ///< a polyline whose end has not been read
  bool closed_ = false;
};

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

/// Texts, dimensions and the like, and everything in paper space.
bool is_annotation(const Entity& entity) {
  static const std::vector<std::string> kinds{"TEXT",     "MTEXT", "DIMENSION", "LEADER", "MULTILEADER", "POINT",
                                              "VIEWPORT", "HATCH", "TOLERANCE", "ATTRIB", "ATTDEF"};
  const auto on_paper = [](const Group& group) { return group.code == 67 && group.value == "1"; };
  return std::find(kinds.begin(), kinds.end(), entity.kind) != kinds.end() ||
         std::any_of(entity.groups.begin(), entity.groups.end(), on_paper);
}

std::string layer_of(const Entity& entity) {
  for (const Group& group : entity.groups)
    if (group.code == 8) return std::string(group.value);
  return "0";
}

/// The wanted entities of a drawing, those of inserted blocks in their places.
class Drawing {
 public:
  Drawing(const DxfFile& file, const std::string& layer, double unit)
      : curves(file, unit), file_(file), layer_(layer), unit_(unit), blocks_(file) {}

  void take(const Entity& entity) {
    if (entity.in_blocks) return blocks_.take(entity);
    add(entity, "", wanted_, 0);
  }

  DxfCurves curves;

 private:
  /// What lies on layer 0 of a block lies on that of its insertion; `wanted` is that of the entity before.
  void add(const Entity& entity, const std::string& of_insertion, bool& wanted, int depth) {
    const std::string own = layer_of(entity), layer = depth > 0 && own == "0" ? of_insertion : own;
    const bool part = entity.kind == "VERTEX" || entity.kind == "SEQEND";  // of the polyline before
    const bool inserts = entity.kind == "INSERT";
    if (!part) wanted = !is_annotation(entity) && (layer_.empty() || layer == layer_);
    if (inserts && !is_annotation(entity)) return insert(entity, layer, depth);
    if (wanted) curves.add(entity);
  }

  void insert(const Entity& entity, const std::string& layer, int depth) {
    constexpr int deepest = 8, most = 10000;
    if (depth == deepest || ++insertions_ > most)
      file_.refuse(entity.line,
                   fmt::format("blocks within blocks over more than {} levels or more than {} of them were "
                               "found, allowed are fewer",
                               deepest, most));
    const DxfBlock& block = blocks_.inserted(entity);
    const DxfPlacement placement = placement_of(file_, entity, block, unit_);
    curves.require_end_of_polyline();
    const std::size_t first = curves.curves.size();
    bool wanted = false;
    for (const Entity& inside : block.entities) add(inside, layer, wanted, depth + 1);
    curves.require_end_of_polyline();
    if (curves.curves.size() > first) curves.require_flat(entity);
    curves.place(first, placement);
  }

  const DxfFile& file_;
  const std::string& layer_;
  double unit_;
  DxfBlocks blocks_;
  bool wanted_ = false;
  int insertions_ = 0;
};

}  // namespace

std::vector<Segment> read_dxf(const CaseNode& node, const std::string& path, const std::string& layer, double unit) {
  const std::string content = core::read_given_file(node, path, "a drawing with its path relative to the case file");
  const DxfFile file{node, path};
  Drawing drawing(file, layer, unit);
  const auto units = read_entities(file, content, [&](const Entity& entity) { drawing.take(entity); });
  if (units) require_same_unit(file, *units, unit);
  DxfCurves& curves = drawing.curves;
  curves.require_end_of_polyline();
  const double straight = tolerance::joined * size_of(curves.curves);
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
    if (curves.bulges[i] != 0) curves.curves[i] = bent(curves.curves[i], curves.bulges[i], straight);
  return std::move(curves.curves);
}

}  // namespace parison::forming
