// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/case/given_file.hpp"
#include "forming/scene/read/curves/csv_points.hpp"
#include "forming/scene/read/curves/curve_arcs.hpp"
#include "forming/scene/read/drawing/path_text.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Profile;
using core::Segment;
namespace dimension = core::dimension;

double part_quantity(const CaseNode& node, std::string_view text, const core::Dimension& expected) {
  return core::text_quantity(node, text, expected);
}

/// The unit of a coordinate: zero needs none.
std::string_view of_points(std::string_view unit, std::string_view coordinate) {
  return unit.empty() && core::trimmed(coordinate) == "0" ? "m" : unit;
}

/// "31, 14" and "mm" to a point.
Point coordinates(const CaseNode& node, std::string_view inside, std::string_view unit) {
  const auto parts = split_coordinates(inside);
  if (parts.size() != core::dim)
    core::refuse(node, fmt::format("\"({})\" has {} coordinates, allowed are {}", inside, parts.size(), core::dim));
  Point point;
  for (std::size_t i = 0; i < core::dim; ++i)
    point[i] = core::text_quantity(node, core::trimmed(parts[i]), dimension::length, of_points(unit, parts[i]));
  return point;
}

/// Points "(31, 14) (29.5, 20) mm" as lines of which only the end is known; nothing when the text is something else.
std::vector<Segment> parse_points(const CaseNode& node) {
  std::vector<Segment> result;
  const auto parts = split_points(node.text);
  if (!parts) return result;
  if (parts->points.size() > max_segments)
    core::refuse(node, fmt::format("{} points were found, allowed are up to {}", parts->points.size(), max_segments));
  for (const auto inside : parts->points) {
    result.emplace_back();
    result.back().end = coordinates(node, inside, parts->unit);
  }
  return result;
}

/// Point of an arc; coordinates that vanish but for round-off are made zero, so that arcs meet axes exactly.
Point on_arc(const Segment& arc, double angle) {
  Point direction(std::cos(angle), std::sin(angle));
  for (auto& component : direction)
    if (std::abs(component) < 1e-14) component = 0;
  return arc.centre + arc.radius * direction;
}

std::vector<Segment> parse_arc(const CaseNode& node) {
  const auto parts = split_arc(node.text);
  if (!parts) return {};
  Segment arc;
  arc.is_arc = true;
  arc.centre = coordinates(node, parts->centre, parts->unit);
  arc.radius = part_quantity(node, parts->radius, dimension::length);
  arc.from = part_quantity(node, parts->from, dimension::none);
  arc.to = part_quantity(node, parts->to, dimension::none);
  if (!(arc.radius > 0) || arc.from == arc.to || std::abs(arc.to - arc.from) > 2 * M_PI)
    core::refuse(node, fmt::format("\"{}\" is no arc, allowed are a radius above zero and up to one turn", node.text));
  arc.start = on_arc(arc, arc.from);
  arc.end = on_arc(arc, arc.to);
  return {arc};
}

std::vector<Segment> parse_path(const CaseNode& node) {
  core::text(node);
  auto parts = parse_points(node);
  if (parts.empty()) parts = parse_arc(node);
  if (parts.empty())
    core::refuse(node, fmt::format("\"{}\" was found, allowed are points such as \"(31, 14) (29.5, 20) mm\" and arcs "
                                   "such as \"arc centre (13.5, 84) mm radius 14 mm from 0 deg to 90 deg\"",
                                   node.text));
  return parts;
}

using Notes = std::vector<std::string>;

std::vector<Segment> read_path_parts(const CaseNode& node, const std::string& directory, Notes& notes);

/// The mirror image of a path about a line, drawn from its end to its start.
std::vector<Segment> read_mirror(const CaseNode& node, const std::string& directory, Notes& notes) {
  const CaseTable table(node, {"mirror", "about"});
  const CaseNode& about = table.get("about");
  core::text(about);
  const auto line = parse_points(about);
  if (line.size() != 2 || line[0].end == line[1].end)
    core::refuse(about,
                 fmt::format("\"{}\" was found, allowed are two points of the line such as \"(0, 40) (10, 40) mm\"",
                             about.text));
  return mirrored(read_path_parts(table.get("mirror"), directory, notes), line[0].end, line[1].end);
}

bool is_mirror(const CaseNode& node) {
  return std::any_of(node.items.begin(), node.items.end(), [](const CaseNode& item) { return item.name == "mirror"; });
}

/// Points, an arc, a mirror image, or a part of a drawing preceded by the point where it starts.
std::vector<Segment> read_path_part(const CaseNode& node, const std::string& directory, Notes& notes) {
  if (node.kind != CaseNode::Kind::table) return parse_path(node);
  if (is_mirror(node)) return read_mirror(node, directory, notes);
  std::vector<Segment> parts = read_section(node, directory, notes);
  if (parts.empty())
    core::refuse(node, "the part of the drawing between from and to has no length, allowed are two different points");
  parts.insert(parts.begin(), Segment{});
  parts.front().end = parts[1].start;
  return parts;
}

std::vector<Segment> read_path_parts(const CaseNode& node, const std::string& directory, Notes& notes) {
  if (node.kind != CaseNode::Kind::list) return read_path_part(node, directory, notes);
  std::vector<Segment> parts;
  for (const auto& item : core::list(node))
    for (const auto& part : read_path_part(item, directory, notes)) parts.push_back(part);
  return parts;
}

std::vector<Segment> read_path(const CaseTable& boundary, const std::string& directory, Notes& notes) {
  const auto *path = boundary.find("path"), *csv = boundary.find("csv");
  if (path && csv) core::refuse(*csv, "path and csv were found, allowed is one of them");
  const auto* smooth = boundary.find("smooth");
  if (smooth && !csv) core::refuse(*smooth, "found without csv, allowed is to smooth the points of a CSV file");
  if (csv && smooth && core::flag(*smooth)) return smoothed(*smooth, read_csv_points(*csv, directory));
  if (csv) return read_csv_points(*csv, directory);
  return read_path_parts(boundary.get("path"), directory, notes);
}

/// Draws segments one after the other, joining what does not meet by lines.
struct Pen {
  Profile& profile;
  double joined;  ///< points closer than this are one, m
  Point at = Point::Zero(), first = Point::Zero();
  bool started = false;

  void line_to(const Point& end, core::Index boundary_id) {
    if (!started) first = at = end;
    started = true;
    if ((end - at).norm() <= joined) return;
    Segment line;
    line.start = at;
    line.end = end;
    line.boundary_id = boundary_id;
    profile.segments.push_back(line);
    at = end;
  }

  void draw(Segment part, core::Index boundary_id) {
    if (!part.is_arc) return line_to(part.end, boundary_id);
    line_to(part.start, boundary_id);
    part.start = at;
    part.boundary_id = boundary_id;
    profile.segments.push_back(part);
    at = part.end;
  }

  void close(core::Index boundary_id) {
    line_to(first, boundary_id);
    if (!profile.segments.empty()) profile.segments.back().end = first;
  }
};

/// The outline whose boundaries have these parts.
Profile draw(const std::vector<std::vector<Segment>>& paths, double joined) {
  Profile profile;
  Pen pen{profile, joined};
  const auto last = static_cast<core::Index>(paths.size()) - 1;
  for (core::Index i = 0; i <= last; ++i) {
    for (const Segment& part : paths[i]) pen.draw(part, i);
    if (i == last) pen.close(i);
  }
  return profile;
}

}  // namespace

CaseTable boundary_table(const CaseNode& node) {
  return CaseTable(node, {"name", "path", "csv", "smooth", "condition"});
}

Point read_point(const CaseNode& node) {
  core::text(node);
  const auto parts = parse_points(node);
  if (parts.size() != 1)
    core::refuse(node, fmt::format("\"{}\" was found, allowed is a point such as \"(31, 14) mm\"", node.text));
  return parts.front().end;
}

Profile read_outline(const CaseNode& boundaries, const std::string& directory, Notes& notes) {
  std::vector<std::string> names;
  std::vector<std::vector<Segment>> paths;
  std::size_t count = 0;
  for (const auto& item : core::list(boundaries)) {
    const CaseTable boundary = boundary_table(item);
    names.push_back(core::text(boundary.get("name")));
    paths.push_back(read_path(boundary, directory, notes));
    count += paths.back().size();
    if (count > max_segments)
      core::refuse(item, fmt::format("{} points and arcs were found so far, allowed are up to {} in an outline", count,
                                     max_segments));
  }
  Profile profile = draw(paths, tolerance::joined * core::size(draw(paths, 0)));
  profile.boundary_names = std::move(names);
  for (std::size_t i = 0; i < paths.size(); ++i)
    if (std::none_of(profile.segments.begin(), profile.segments.end(),
                     [&](const Segment& segment) { return segment.boundary_id == static_cast<core::Index>(i); }))
      core::refuse(boundaries.items[i], "the path has no length, allowed is at least one line or arc");
  if (profile.segments.size() < 2)
    core::refuse(boundaries, fmt::format("{} lines were found, allowed is a closed outline", profile.segments.size()));
  return profile;
}

namespace {

/// Where two segments of an outline cross or come closest, away from an end that they share.
Point crossing_of(const Segment& one, const Segment& other) {
  constexpr int count = 2000;
  const double shared = 1e-3 * std::min(core::length(one), core::length(other));
  Point place = one.start;
  double nearest = HUGE_VAL;
  for (int i = 0; i <= count; ++i) {
    const Point x = core::point_at(one, double(i) / count);
    if ((x - other.start).norm() < shared || (x - other.end).norm() < shared) continue;
    const double distance = (x - core::point_at(other, core::closest_parameter(other, x))).norm();
    if (distance < nearest) nearest = distance, place = x;
  }
  return place;
}

}  // namespace

void check_outline(const Profile& profile, core::Geometry geometry, const CaseNode& boundaries) {
  const auto [a, b] = core::find_self_crossing(profile);
  if (a >= 0) {
    const auto &one = profile.segments[a], &other = profile.segments[b];
    const Point at = 1e3 * crossing_of(one, other);
    core::refuse(
        boundaries.items[one.boundary_id],
        fmt::format("the outline crosses itself (boundary \"{}\" meets boundary \"{}\" near ({:.4g}, {:.4g}) mm), "
                    "allowed is an outline that does not touch itself",
                    profile.boundary_names[one.boundary_id], profile.boundary_names[other.boundary_id], at[0], at[1]));
  }
  const double size = core::size(profile), joined = tolerance::joined * size;
  if (std::abs(core::signed_area(profile)) <= joined * size)
    core::refuse(boundaries, "the outline encloses no area, allowed is one that leads around a body");
  if (geometry == core::Geometry::planar) return;
  for (const auto& segment : profile.segments)
    for (int i = 0; i <= 16; ++i)
      if (const auto x = core::point_at(segment, i / 16.0); x[0] < -joined)
        core::refuse(boundaries.items[segment.boundary_id],
                     fmt::format("({:g}, {:g}) mm is on the wrong side of the axis, allowed are radii from zero",
                                 1e3 * x[0], 1e3 * x[1]));
}

}  // namespace parison::forming
