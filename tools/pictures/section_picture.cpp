// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/pictures/section_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "forming/scene/container/container_plan.hpp"

namespace parison::tools {
namespace {

using core::Index;
using core::Point;
using forming::Scene;

constexpr double height = 640, margin = 30, title = 60;  // of a panel, pixels
constexpr std::array colours{"#9db4c0", "#c2b8a3", "#a3b18a", "#d4a5a5", "#b5a7c9", "#c9c27f", "#8fbcbb", "#d0a98f"};

struct Range {
  Point low, high;  ///< m
};

/// Tools that are active together, and the stages in which they are.
struct Panel {
  std::set<Index> tools;
  std::string stages;
};

std::vector<Panel> panels_of(const Scene& scene) {
  std::vector<Panel> panels;
  for (const forming::Stage& stage : scene.stages) {
    std::set<Index> tools;
    for (const forming::StageTool& tool : stage.tools) tools.insert(tool.tool);
    const auto same =
        std::find_if(panels.begin(), panels.end(), [&](const Panel& panel) { return panel.tools == tools; });
    if (same == panels.end())
      panels.push_back({tools, stage.name});
    else
      same->stages += ", " + stage.name;
  }
  return panels;
}

std::vector<Point> outline_of(const forming::Body& body, double shift) {
  const double size = core::size(body.profile);
  std::vector<Point> points = core::polyline(body.profile, size, 2e-4 * size);
  for (Point& x : points) x += shift * core::axis_direction();
  return points;
}

Range range_of(const Scene& scene) {
  Range range{scene.glass.profile.segments.front().start, scene.glass.profile.segments.front().start};
  const auto include = [&](const forming::Body& body) {
    for (const Point& x : outline_of(body, body.position)) {
      range.low = range.low.cwiseMin(x);
      range.high = range.high.cwiseMax(x);
    }
  };
  include(scene.glass);
  for (const forming::Tool& tool : scene.tools) include(tool);
  if (scene.geometry == core::Geometry::axisymmetric) range.low[0] = -range.high[0];
  return range;
}

/// From metres to the pixels of a panel.
struct Frame {
  Range range;
  double scale, left;

  Point operator()(const Point& x) const {
    return {left + margin + scale * (x[0] - range.low[0]), title + scale * (range.high[1] - x[1])};
  }
};

std::string path_of(const Frame& frame, const std::vector<Point>& points, double side) {
  std::string path;
  for (const Point& x : points) {
    const Point at = frame(Point(side * x[0], x[1]));
    path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : " L", at[0], at[1]);
  }
  return path + " Z";
}

/// A body and, where it turns about the axis, its other half.
std::string body_shape(const Frame& frame, const Scene& scene, const std::vector<Point>& points,
                       const std::string& style) {
  std::string text = fmt::format("<path d=\"{}\" {}/>\n", path_of(frame, points, 1), style);
  if (scene.geometry == core::Geometry::axisymmetric)
    text += fmt::format("<path d=\"{}\" {}/>\n", path_of(frame, points, -1), style);
  return text;
}

std::string label(const Point& at, const std::string& text, int size) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{}\" text-anchor=\"middle\">{}</text>\n", at[0],
                     at[1], size, text);
}

/// The place inside an outline that is farthest from it, of some hundred, for a name.
Point place_of_name(const core::Profile& profile) {
  constexpr int places = 24;
  Range box{profile.segments.front().start, profile.segments.front().start};
  for (const core::Segment& segment : profile.segments)
    for (const double t : {0.0, 0.5})
      box.low = box.low.cwiseMin(core::point_at(segment, t)), box.high = box.high.cwiseMax(core::point_at(segment, t));
  Point best = 0.5 * (box.low + box.high);
  double depth = 0;
  for (int i = 1; i < places; ++i)
    for (int k = 1; k < places; ++k) {
      const Point x = box.low + Point(i, k).cwiseProduct(box.high - box.low) / places;
      if (const double d = core::contains(profile, x) ? core::distance(profile, x) : 0.0; d > depth)
        depth = d, best = x;
    }
  return best;
}

std::string tool_shapes(const Frame& frame, const Scene& scene, const Panel& panel) {
  std::string text, names;
  for (const Index i : panel.tools) {
    const forming::Tool& tool = scene.tools[i];
    const auto style = fmt::format("fill=\"{}\" fill-opacity=\"0.8\" stroke=\"#333\" stroke-width=\"0.8\"",
                                   colours[static_cast<std::size_t>(i) % colours.size()]);
    text += body_shape(frame, scene, outline_of(tool, tool.position), style);
    names += label(frame(place_of_name(tool.profile) + tool.position * core::axis_direction()), tool.name, 13);
  }
  return text + names;
}

/// The axis, a bar of a length to compare with, the title.
std::string frame_lines(const Frame& frame, const Scene& scene, const Panel& panel, double width) {
  std::string text = label({frame.left + width / 2, 24}, panel.stages, 15);
  if (scene.geometry == core::Geometry::axisymmetric) {
    const Point low = frame(Point(0, frame.range.low[1])), high = frame(Point(0, frame.range.high[1]));
    text += fmt::format(
        "<path d=\"M{:.2f} {:.2f} L{:.2f} {:.2f}\" stroke=\"#c00\" stroke-width=\"1\" "
        "stroke-dasharray=\"12 3 2 3\"/>\n",
        low[0], low[1] + 8, high[0], high[1] - 8);
  }
  double bar = 1e-6;  // m
  while (bar * 10 * frame.scale < width / 2) bar *= 10;
  const double x = frame.left + margin, y = title + height + 22;
  text +=
      fmt::format("<path d=\"M{:.2f} {:.2f} h{:.2f}\" stroke=\"#000\" stroke-width=\"2\"/>\n", x, y, bar * frame.scale);
  return text + fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\">{:g} mm</text>\n", x, y + 16, 1e3 * bar);
}

/// The plunger where the press ends.
std::string end_of_press(const Frame& frame, const Scene& scene, const Panel& panel) {
  const auto plan = forming::container_plan(scene);
  if (!plan || !plan->press || !panel.tools.count(plan->press->tool)) return "";
  const auto outline = outline_of(scene.tools[plan->press->tool], plan->press->stop);
  return body_shape(frame, scene, outline, "fill=\"none\" stroke=\"#000\" stroke-width=\"1\" stroke-dasharray=\"5 4\"");
}

}  // namespace

std::string section_picture(const Scene& scene) {
  const Range range = range_of(scene);
  const double scale = height / (range.high - range.low).maxCoeff();
  const double width = scale * (range.high - range.low)[0] + 2 * margin;
  const std::vector<Panel> panels = panels_of(scene);
  std::string body;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Frame frame{range, scale, static_cast<double>(i) * width};
    body += tool_shapes(frame, scene, panels[i]);
    if (i == 0) {
      body += body_shape(frame, scene, outline_of(scene.glass, 0),
                         "fill=\"#f4a259\" stroke=\"#a34a00\" stroke-width=\"1\"");
      body += label(frame(place_of_name(scene.glass.profile)), "glass", 13);
    }
    body += end_of_press(frame, scene, panels[i]) + frame_lines(frame, scene, panels[i], width);
  }
  const double whole = width * static_cast<double>(panels.size());
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\" font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<title>{2}"
      "</title>\n{3}</svg>\n",
      whole, title + height + 50, scene.name, body);
}

}  // namespace parison::tools
