// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/contour/given_contour.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "core/case/case_file.hpp"
#include "core/case/text/case_text.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "tools/workbench/contour/walls.hpp"
#include "tools/workbench/handles/handles.hpp"

namespace parison::tools {
namespace {

using core::CaseNode;
using core::Point;

constexpr double mm = 1e-3, same = 1e-7;  // m

/// A boundary of a tool as it is in the file.
struct Target {
  std::string directory, tool_key;  ///< "tool.2"
  CaseNode tool;
  std::size_t boundary;
  core::Profile profile;

  const std::vector<CaseNode>& boundaries() const { return member(tool, "boundary")->items; }
  std::string condition(std::size_t i) const {
    const CaseNode* node = member(boundaries()[i], "condition");
    return node ? node->text : "";
  }
  std::vector<core::Segment> segments(bool own) const {
    std::vector<core::Segment> found;
    for (const core::Segment& segment : profile.segments)
      if ((segment.boundary_id == static_cast<core::Index>(boundary)) == own) found.push_back(segment);
    return found;
  }
};

Target target_of(const std::string& case_file, const std::string& key) {
  static const std::regex form("(tool\\.([0-9]{1,4}))\\.boundary\\.([0-9]{1,4})\\.path");
  const core::CaseFile file = evaluated_case(case_file);
  std::smatch match;
  const CaseNode* tools = member(file.root, "tool");
  const std::size_t tool = std::regex_match(key, match, form) ? std::stoul(match[2]) : 0;
  const CaseNode* list = tools && tool < tools->items.size() ? member(tools->items[tool], "boundary") : nullptr;
  if (match.empty() || !list || std::stoul(match[3]) >= list->items.size())
    throw core::CaseError(fmt::format("\"{}\" was found, allowed is the path of a boundary of a tool", key));
  std::vector<std::string> notes;
  return {file.directory, match[1], tools->items[tool], std::stoul(match[3]),
          forming::read_outline(*list, file.directory, notes)};
}

/// A number of mm or degrees.
double rounded(double value) {
  return std::round(1e4 * value) / 1e4 + 0.0;
}

std::string point_text(const Point& x) {
  return fmt::format("({}, {})", rounded(x[0] / mm), rounded(x[1] / mm));
}

using Values = std::vector<std::pair<const char*, std::string>>;

/// An inline table of the values that are given.
std::string table_text(const Values& values) {
  std::string text;
  for (const auto& [key, value] : values)
    if (!value.empty()) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, core::quoted(value));
  return "{ " + text + " }";
}

std::string path_text(const DrawnContour& contour) {
  return table_text({{"file", contour.file},
                     {"unit", contour.unit},
                     {"layer", contour.layer},
                     {"from", contour.from},
                     {"via", contour.via},
                     {"to", contour.to},
                     {"origin", contour.origin},
                     {"axis", contour.axis},
                     {"turn", contour.turn}});
}

std::string sections_text(const DrawnContour& contour) {
  return table_text(
      {{"file", contour.file}, {"origin", contour.origin}, {"axis", contour.axis}, {"turn", contour.turn}});
}

CaseNode node_of(const std::string& text) {
  CaseNode place;
  place.key = "drawing";
  return core::parse_value(text, place);
}

std::vector<core::Segment> read(const Target& target, const DrawnContour& contour) {
  std::vector<std::string> notes;
  auto segments = forming::read_section(node_of(path_text(contour)), target.directory, notes);
  if (segments.empty()) throw core::CaseError("the contour has no length, allowed are two different places");
  return segments;
}

/// Segments that follow each other as a `path`: texts of points and arcs.
std::string points_text(const std::vector<core::Segment>& segments) {
  constexpr double degree = M_PI / 180;
  std::string list, points = point_text(segments.front().start);
  const auto add = [&](const std::string& text) { list += (list.empty() ? "" : ", ") + core::quoted(text); };
  const auto end_points = [&] {
    if (!points.empty()) add(points + " mm");
    points.clear();
  };
  for (const core::Segment& segment : segments) {
    if (!segment.is_arc) {
      points += (points.empty() ? "" : " ") + point_text(segment.end);
      continue;
    }
    end_points();
    add(fmt::format("arc centre {} mm radius {} mm from {} deg to {} deg", point_text(segment.centre),
                    rounded(segment.radius / mm), rounded(segment.from / degree), rounded(segment.to / degree)));
  }
  end_points();
  return "[" + list + "]";
}

Point point_of(const std::string& text) {
  return forming::read_point(node_of(core::quoted(text)));
}

/// Whether a contour is of the section of a solid, which is in the frame of its axis already.
bool is_of_solid(const Target& target, const DrawnContour& contour) {
  const CaseNode node = node_of(path_text(contour));
  std::vector<std::string> notes;
  const core::CaseTable table(node, {"file", "from", "via", "to", "unit", "layer", "origin", "axis", "turn"});
  return forming::read_drawing(table, target.directory, notes).is_cut;
}

/// The contour higher by so much along z of the case.
void lift(const Target& target, DrawnContour& contour, double by) {
  for (std::string* place : {&contour.from, &contour.via, &contour.to})
    if (!place->empty()) *place = point_text(point_of(*place) + by * core::axis_direction()) + " mm";
  const std::string axis = is_of_solid(target, contour) ? "" : contour.axis;
  const bool across = axis == "x" || axis == "-x";
  const double sign = axis.compare(0, 1, "-") == 0 ? -1 : 1;
  const Point origin = contour.origin.empty() ? Point::Zero() : point_of(contour.origin);
  contour.origin = point_text(origin - sign * by * (across ? Point(1, 0) : Point(0, 1))) + " mm";
}

const Point* end_on_axis(const std::vector<core::Segment>& segments) {
  for (const Point* x : {&segments.front().start, &segments.back().end})
    if (std::abs((*x)[0]) < same) return x;
  return nullptr;
}

/// Runs the contour as that of the boundary did, and brings that of a tool with a position to where that one was.
void place_as(const Target& target, DrawnContour& contour) {
  const auto before = target.segments(true), after = read(target, contour);
  const auto along = [](const auto& segments) -> Point { return segments.back().end - segments.front().start; };
  if (!contour.to.empty() && along(before).dot(along(after)) < 0) std::swap(contour.from, contour.to);
  const Point *was = end_on_axis(before), *is = end_on_axis(after);
  if (member(target.tool, "position") && was && is && std::abs((*was)[1] - (*is)[1]) > same)
    lift(target, contour, (*was)[1] - (*is)[1]);
}

bool differ(const Contour& one, const Contour& other) {
  return (one.begin() - other.begin()).norm() > same || (one.end() - other.end()).norm() > same ||
         std::abs(one.width() - other.width()) > same;
}

/// The paths behind the contour, where those of the file do not lead around it.
std::vector<std::string> walls(const Target& target, const DrawnContour& drawn) {
  const auto before = target.segments(true);
  const double sense = core::signed_area(target.profile) * (before.back().end[1] - before.front().start[1]);
  const Contour was{before, sense > 0}, is{read(target, drawn), sense > 0};
  const std::size_t count = target.boundaries().size() - 1;
  const bool asked = !drawn.thickness.empty();
  const double thickness =
      asked ? core::positive(node_of(core::quoted(drawn.thickness)), core::dimension::length) : NAN;
  const auto none = [&]() -> std::vector<std::string> {
    if (asked)
      throw core::CaseError(fmt::format(
          "no wall of {} can be made behind this contour and the {} other boundaries of the tool, allowed is none",
          drawn.thickness, count));
    return {};
  };
  if (target.boundary != 0 || sense == 0) return none();
  if (!asked && !differ(was, is)) return {};
  const auto behind = walls_behind(is, asked ? thickness : thickness_behind(was, target.segments(false)), count);
  if (!behind) return none();
  const double end = is.end()[0];
  std::vector<std::string> assignments;
  for (std::size_t i = 1; i <= count; ++i) {
    const bool on_axis = std::abs(end) < same ? i == 1 : std::abs(is.begin()[0]) < same && i == count;
    if ((target.condition(i) == "symmetry") != on_axis) return none();
    std::string path;
    for (const Point& x : (*behind)[i - 1]) path += point_text(x) + " ";
    assignments.push_back(fmt::format("{}.boundary.{}.path={}", target.tool_key, i, core::quoted(path + "mm")));
  }
  return assignments;
}

}  // namespace

std::vector<std::string> given_contour(const std::string& case_file, const std::string& key,
                                       const DrawnContour& contour) {
  const Target target = target_of(case_file, key);
  DrawnContour drawn = contour;
  std::vector<std::string> assignments;
  if (target.condition(target.boundary) == "contact") {
    place_as(target, drawn);
    assignments = walls(target, drawn);
  }
  const std::string path = drawn.as_points ? points_text(read(target, drawn)) : path_text(drawn);
  assignments.insert(assignments.begin(), fmt::format("{}={}", key, path));
  if (drawn.with_sections) assignments.push_back(fmt::format("{}.section={}", target.tool_key, sections_text(drawn)));
  return assignments;
}

}  // namespace parison::tools
