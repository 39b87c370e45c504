// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "core/case/text/case_text.hpp"
#include "core/case/units.hpp"
#include "forming/scene/read/drawing/path_text.hpp"
#include "tools/workbench/handles/handles.hpp"

namespace parison::tools {
namespace {

constexpr double same = 1e-9;  // m

/// A coordinate that is a plain number in the unit behind the points.
std::optional<double> coordinate(std::string_view text, std::string_view unit) {
  const auto found = core::parse_quantity(fmt::format("{} {}", text, unit), core::dimension::length);
  if (unit.empty() || !found.problem.empty()) return {};
  return found.value;
}

std::optional<core::Point> point_of(std::string_view inside, std::string_view unit) {
  const auto parts = forming::split_coordinates(inside);
  if (parts.size() != 2) return {};
  const auto r = coordinate(parts[0], unit), z = coordinate(parts[1], unit);
  if (!r || !z) return {};
  return core::Point(*r, *z);
}

/// Whether a path is from a drawing, or a part of it.
bool is_drawn(const core::CaseNode& path) {
  return path.kind == core::CaseNode::Kind::table || std::any_of(path.items.begin(), path.items.end(), is_drawn);
}

/// A tool, and which of its boundaries are from drawings.
struct DrawnTool {
  const forming::Tool& tool;
  std::vector<bool> drawn;
};

/// Whether a point is a corner of straight sides alone, one of which the glass may touch: an arc or a drawing would not
/// follow it.
bool is_free_corner(const DrawnTool& one, const core::Point& x) {
  const forming::Tool& tool = one.tool;
  bool meets_glass = false;
  for (const core::Segment& segment : tool.profile.segments) {
    if ((segment.start - x).norm() > same && (segment.end - x).norm() > same) continue;
    if (segment.is_arc || one.drawn[static_cast<std::size_t>(segment.boundary_id)]) return false;
    meets_glass = meets_glass || tool.boundaries[segment.boundary_id].kind == core::BoundaryKind::contact;
  }
  return meets_glass;
}

const core::CaseNode* member(const core::CaseNode* node, const std::string& name) {
  if (node)
    for (const core::CaseNode& item : node->items)
      if (item.name == name) return &item;
  return nullptr;
}

/// Adds the corners that one text of a path names.
void add_corners(const DrawnTool& one, const std::string& key, const std::string& text,
                 std::vector<CornerHandle>& handles) {
  const forming::Tool& tool = one.tool;
  const auto points = forming::split_points(text);
  for (std::size_t i = 0; points && i < points->points.size(); ++i) {
    const auto x = point_of(points->points[i], points->unit);
    if (!x || !is_free_corner(one, *x)) continue;
    auto found = std::find_if(handles.begin(), handles.end(), [&](const CornerHandle& other) {
      return other.tool == tool.name && (other.at - *x).norm() < same;
    });
    if (found == handles.end()) found = handles.insert(handles.end(), {tool.name, *x, tool.position, {}});
    found->places.push_back({key, text, i});
  }
}

void add_path(const DrawnTool& tool, const std::string& key, const core::CaseNode& path,
              std::vector<CornerHandle>& handles) {
  if (path.kind == core::CaseNode::Kind::text) add_corners(tool, key, path.text, handles);
  for (std::size_t i = 0; i < path.items.size(); ++i)
    add_path(tool, fmt::format("{}.{}", key, i), path.items[i], handles);
}

/// A text of a path with one of its points elsewhere.
std::string with_point(const std::string& text, std::size_t number, const core::Point& to) {
  const auto points = forming::split_points(text);
  const double unit = *coordinate("1", points->unit);
  const std::string_view inside = points->points[number];
  const auto begin = static_cast<std::size_t>(inside.data() - text.data());
  const auto shown = [&](double value) { return std::round(1e6 * value / unit) / 1e6 + 0.0; };
  return text.substr(0, begin) + fmt::format("{}, {}", shown(to[0]), shown(to[1])) + text.substr(begin + inside.size());
}

}  // namespace

std::vector<CornerHandle> corner_handles(const std::string& case_file, const forming::Scene& scene) {
  const core::CaseFile file = core::read_case_file(case_file);
  const core::CaseNode* tools = member(&file.root, "tool");
  std::vector<CornerHandle> handles;
  for (std::size_t t = 0; tools && t < tools->items.size() && t < scene.tools.size(); ++t) {
    const core::CaseNode* boundaries = member(&tools->items[t], "boundary");
    DrawnTool one{scene.tools[t], {}};
    for (std::size_t b = 0; boundaries && b < boundaries->items.size(); ++b) {
      const auto* path = member(&boundaries->items[b], "path");
      one.drawn.push_back(!path || is_drawn(*path));
    }
    for (std::size_t b = 0; boundaries && b < boundaries->items.size(); ++b)
      if (const auto* path = member(&boundaries->items[b], "path"))
        add_path(one, fmt::format("tool.{}.boundary.{}.path", t, b), *path, handles);
  }
  return handles;
}

std::vector<std::string> moved_corner(const std::vector<CornerHandle>& handles, double number, const core::Point& to) {
  if (!(number >= 0 && number < static_cast<double>(handles.size())) || !to.allFinite())
    throw core::CaseError("no such corner was found, the case has changed");
  const CornerHandle& handle = handles[static_cast<std::size_t>(number)];
  const core::Point own = (handle.at[0] == 0 ? core::Point(0, to[1]) : to) - handle.position * core::axis_direction();
  std::vector<std::string> assignments;
  auto places = handle.places;
  while (!places.empty()) {  // those of one text together
    const std::string key = places.front().key;
    std::string path = places.front().path;
    for (const auto& place : places)
      if (place.key == key) path = with_point(path, place.point, own);
    assignments.push_back(fmt::format("{}={}", key, core::quoted(path)));
    places.erase(std::remove_if(places.begin(), places.end(), [&](const auto& one) { return one.key == key; }),
                 places.end());
  }
  return assignments;
}

}  // namespace parison::tools
