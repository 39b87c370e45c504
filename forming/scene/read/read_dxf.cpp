// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "forming/scene/read/read_section.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::Point;
using core::Segment;

/// A pair of lines of a DXF file.
struct Group {
  int code;
  std::string value;
  int line;
};

struct Entity {
  std::string kind;
  std::vector<Group> groups;
  int line;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

[[noreturn]] void refuse_line(const CaseNode& file, const std::string& path, int line, const std::string& message) {
  CaseNode at = file;
  at.file = path;
  at.line = line;
  core::refuse(at, message);
}

std::vector<Group> read_groups(const CaseNode& file, const std::string& path) {
  std::ifstream in(path);
  if (!in)
    core::refuse(file,
                 fmt::format("no file \"{}\", allowed is a drawing with its path relative to the case file", path));
  std::vector<Group> groups;
  std::string code, value;
  for (int line = 1; std::getline(in, code) && std::getline(in, value); line += 2) {
    char* end = nullptr;
    const std::string number = trimmed(code);
    const long found = std::strtol(number.c_str(), &end, 10);
    if (number.empty() || *end != '\0')
      refuse_line(file, path, line,
                  fmt::format("\"{}\" was found, allowed is a group code of an ASCII DXF file", number.substr(0, 40)));
    groups.push_back({static_cast<int>(found), trimmed(value), line + 1});
  }
  return groups;
}

/// Those of the ENTITIES section.
std::vector<Entity> read_entities(const CaseNode& file, const std::string& path) {
  std::vector<Entity> entities;
  bool inside = false;
  const auto groups = read_groups(file, path);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group& group = groups[i];
    if (group.code == 0 && group.value == "ENDSEC") inside = false;
    if (inside && group.code == 0)
      entities.push_back({group.value, {}, group.line});
    else if (inside && !entities.empty())
      entities.back().groups.push_back(group);
    if (group.code == 2 && group.value == "ENTITIES" && i > 0 && groups[i - 1].value == "SECTION") inside = true;
  }
  return entities;
}

/// The curves of the wanted entities, one entity after the other.
class DxfCurves {
 public:
  DxfCurves(const CaseNode& file, std::string path, double unit) : file_(file), path_(std::move(path)), unit_(unit) {}

  void add(const Entity& entity) {
    if (number(entity, 230, 1) < 0)
      refuse(entity,
             fmt::format(
                 "a {} with a negative extrusion direction (seen from behind) was found, allowed is a positive one",
                 entity.kind));
    if (entity.kind == "LINE")
      add_line(point(entity, 10, 20), point(entity, 11, 21));
    else if (entity.kind == "ARC")
      add_arc(entity, number(entity, 50), number(entity, 51));
    else if (entity.kind == "CIRCLE")
      add_arc(entity, 0, 180), add_arc(entity, 180, 360);
    else if (entity.kind == "LWPOLYLINE")
      begin_polyline(entity), add_light_vertices(entity), end_polyline();
    else if (entity.kind == "POLYLINE")
      begin_polyline(entity);
    else if (entity.kind == "VERTEX")
      add_vertex(point(entity, 10, 20), number(entity, 42, 0));
    else if (entity.kind == "SEQEND")
      end_polyline();
    else
      refuse(
          entity,
          fmt::format("a {} was found, allowed are LINE, ARC, CIRCLE, LWPOLYLINE and POLYLINE (explode or convert it "
                      "in the CAD program, or choose a layer without it)",
                      entity.kind));
  }
  std::vector<Segment> curves;

 private:
  [[noreturn]] void refuse(const Entity& entity, const std::string& message) const {
    refuse_line(file_, path_, entity.line, message);
  }

  double value_of(const Group& group) const {
    char* end = nullptr;
    const double value = std::strtod(group.value.c_str(), &end);
    if (group.value.empty() || *end != '\0' || !std::isfinite(value))
      refuse_line(file_, path_, group.line, fmt::format("\"{}\" was found, allowed is a number", group.value));
    return value;
  }

  double number(const Entity& entity, int code, double otherwise = std::nan("")) const {
    for (const Group& group : entity.groups)
      if (group.code == code) return value_of(group);
    if (std::isnan(otherwise))
      refuse(entity, fmt::format("a {} without group {} was found, allowed is one with it", entity.kind, code));
    return otherwise;
  }

  Point point(const Entity& entity, int x, int y) const { return unit_ * Point(number(entity, x), number(entity, y)); }

  void add_line(const Point& start, const Point& end) {
    Segment line;
    line.start = start;
    line.end = end;
    curves.push_back(line);
  }

  /// Counterclockwise between two angles in degrees.
  void add_arc(const Entity& entity, double from, double to) {
    Segment arc;
    arc.is_arc = true;
    arc.centre = point(entity, 10, 20);
    arc.radius = unit_ * number(entity, 40);
    if (!(arc.radius > 0))
      refuse(entity, fmt::format("an {} without a radius was found, allowed are radii above zero", entity.kind));
    arc.from = from * M_PI / 180;
    arc.to = (to > from ? to : to + 360) * M_PI / 180;
    arc.start = arc.centre + arc.radius * Point(std::cos(arc.from), std::sin(arc.from));
    arc.end = arc.centre + arc.radius * Point(std::cos(arc.to), std::sin(arc.to));
    curves.push_back(arc);
  }

  /// The bulge is the tangent of a quarter of the angle that the arc turns.
  void add_bulge(const Point& start, const Point& end, double bulge) {
    if (bulge == 0) return add_line(start, end);
    Segment arc;
    arc.is_arc = true;
    arc.start = start;
    arc.end = end;
    const Point along = end - start, left(-along[1], along[0]);
    arc.centre = 0.5 * (start + end) + (1 - bulge * bulge) / (4 * bulge) * left;
    arc.radius = (start - arc.centre).norm();
    arc.from = std::atan2(start[1] - arc.centre[1], start[0] - arc.centre[0]);
    arc.to = arc.from + 4 * std::atan(bulge);
    curves.push_back(arc);
  }

  void begin_polyline(const Entity& entity) {
    const int flags = static_cast<int>(number(entity, 70, 0));
    if ((flags & ~(1 | 128)) != 0)
      refuse(entity,
             fmt::format("a curve-fitted or three-dimensional {} was found, allowed is a plane one of lines and arcs",
                         entity.kind));
    closed_ = (flags & 1) != 0;
    vertices_.clear();
  }

  void add_vertex(const Point& x, double bulge) { vertices_.push_back({x, bulge}); }

  void add_light_vertices(const Entity& entity) {
    for (const Group& group : entity.groups) {
      if (group.code == 10) add_vertex({unit_ * value_of(group), 0}, 0);
      if (vertices_.empty()) continue;
      if (group.code == 20) vertices_.back().x[1] = unit_ * value_of(group);
      if (group.code == 42) vertices_.back().bulge = value_of(group);
    }
  }

  void end_polyline() {
    for (std::size_t i = 1; i < vertices_.size(); ++i)
      add_bulge(vertices_[i - 1].x, vertices_[i].x, vertices_[i - 1].bulge);
    if (closed_ && vertices_.size() > 1) add_bulge(vertices_.back().x, vertices_.front().x, vertices_.back().bulge);
    vertices_.clear();
  }

  struct Vertex {
    Point x;
    double bulge;
  };
  const CaseNode& file_;
  std::string path_;
  double unit_;
  std::vector<Vertex> vertices_;  ///< of the polyline being read
  bool closed_ = false;
};

/// Texts, dimensions and the like, and everything in paper space.
bool is_annotation(const Entity& entity) {
  static const std::vector<std::string> kinds{"TEXT",  "MTEXT",    "DIMENSION", "LEADER",   "MULTILEADER",
                                              "POINT", "VIEWPORT", "HATCH",     "TOLERANCE"};
  const auto on_paper = [](const Group& group) { return group.code == 67 && group.value == "1"; };
  return std::find(kinds.begin(), kinds.end(), entity.kind) != kinds.end() ||
         std::any_of(entity.groups.begin(), entity.groups.end(), on_paper);
}

bool on_layer(const Entity& entity, const std::string& layer) {
  return std::any_of(entity.groups.begin(), entity.groups.end(),
                     [&](const Group& group) { return group.code == 8 && group.value == layer; });
}

}  // namespace

std::vector<Segment> read_dxf(const CaseNode& file, const std::string& path, const std::string& layer, double unit) {
  DxfCurves curves(file, path, unit);
  bool wanted = false;
  for (const Entity& entity : read_entities(file, path)) {
    const bool part = entity.kind == "VERTEX" || entity.kind == "SEQEND";  // of the polyline before
    if (!part) wanted = !is_annotation(entity) && (layer.empty() || on_layer(entity, layer));
    if (wanted) curves.add(entity);
  }
  return std::move(curves.curves);
}

}  // namespace parison::forming
