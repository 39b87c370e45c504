// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/io/svg.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "tools/pictures/pictures.hpp"

namespace parison::tools {
namespace {

namespace svg = core::svg;

using core::Index;
using core::Point;
using forming::Scene;

constexpr double height = 640, margin = 30, title = 60;  // of a panel, pixels
constexpr int name_size = 13, title_size = 15;           // of letters, pixels
constexpr double letter = 0.62;                          // greatest mean width of a letter, in sizes
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

std::string path_of(const Frame& frame, const std::vector<Point>& points, double side, const std::string& style) {
  svg::Path path;
  for (const Point& x : points) {
    const Point at = frame(Point(side * x[0], x[1]));
    path.to(at[0], at[1]);
  }
  return path.close().drawn(style);
}

/// A body and, where it turns about the axis, its other half.
std::string body_shape(const Frame& frame, const Scene& scene, const std::vector<Point>& points,
                       const std::string& style) {
  const bool turns = scene.geometry == core::Geometry::axisymmetric;
  return path_of(frame, points, 1, style) + (turns ? path_of(frame, points, -1, style) : "");
}

/// A body of a panel where it is drawn.
struct Drawn {
  const forming::Body* body;
  std::string name;
  double shift;  ///< along the axis, m

  bool holds(const Point& x) const { return core::contains(body->profile, x - shift * core::axis_direction()); }
};

/// The place in a body that is farthest from its outline and from the other bodies, of some hundred; where these cover
/// it everywhere, from its outline.
Point place_in(const Drawn& drawn, const std::vector<Drawn>& others) {
  constexpr int places = 24;
  const core::Profile& profile = drawn.body->profile;
  Range box{profile.segments.front().start, profile.segments.front().start};
  for (const core::Segment& segment : profile.segments)
    for (const double t : {0.0, 0.5})
      box.low = box.low.cwiseMin(core::point_at(segment, t)), box.high = box.high.cwiseMax(core::point_at(segment, t));
  const Point shift = drawn.shift * core::axis_direction();
  const auto clearance = [&](const Point& x) {  // from the other bodies, m; negative below one of them
    double least = 1e9;
    for (const Drawn& other : others)
      if (other.body != drawn.body)
        least = std::min(least, (other.holds(x) ? -1 : 1) *
                                    core::distance(other.body->profile, x - other.shift * core::axis_direction()));
    return least;
  };
  std::array<Point, 2> best{0.5 * (box.low + box.high) + shift, 0.5 * (box.low + box.high) + shift};
  std::array<double, 2> depth{0, 0};  // of places that are covered, of such that are not
  for (int i = 1; i < places; ++i)
    for (int k = 1; k < places; ++k) {
      const Point x = box.low + Point(i, k).cwiseProduct(box.high - box.low) / places;
      double d = core::contains(profile, x) ? core::distance(profile, x) : 0.0;
      const double clear = clearance(x + shift);
      const std::size_t seen = clear > 0 ? 1 : 0;
      if (seen) d = std::min(d, clear);
      if (d > depth[seen]) depth[seen] = d, best[seen] = x + shift;
    }
  return best[depth[1] > 0 ? 1 : 0];
}

std::vector<Drawn> drawn_in(const Scene& scene, const Panel& panel, bool with_glass) {
  std::vector<Drawn> drawn;
  for (const Index i : panel.tools) drawn.push_back({&scene.tools[i], scene.tools[i].name, scene.tools[i].position});
  if (with_glass) drawn.push_back({&scene.glass, "glass", 0});
  return drawn;
}

std::string tool_shapes(const Frame& frame, const Scene& scene, const Panel& panel) {
  std::string text;
  for (const Index i : panel.tools)
    text += body_shape(frame, scene, outline_of(scene.tools[i], scene.tools[i].position),
                       fmt::format("fill=\"{}\" fill-opacity=\"0.8\" stroke=\"#333\" stroke-width=\"0.8\"",
                                   colours[static_cast<std::size_t>(i) % colours.size()]));
  return text;
}

/// Heights of lines of text, as near to those wanted as they can be at least a line apart; ordered like these.
std::vector<double> spread(std::vector<double> wanted, double line) {
  struct Block {
    double centre;  ///< mean of what its lines want, less their places in it
    std::size_t lines;
  };
  std::vector<Block> blocks;
  for (const double at : wanted) {
    blocks.push_back({at, 1});
    while (blocks.size() > 1) {
      const Block last = blocks.back(), before = blocks[blocks.size() - 2];
      const double n = double(before.lines), m = double(last.lines);
      if (last.centre - before.centre >= 0.5 * line * (n + m)) break;
      blocks.pop_back();
      const double top =
          (n * (before.centre - 0.5 * line * (n - 1)) + m * (last.centre - 0.5 * line * (m - 1) - n * line)) / (n + m);
      blocks.back() = {top + 0.5 * line * (n + m - 1), before.lines + last.lines};
    }
  }
  std::vector<double> places;
  for (const Block& block : blocks)
    for (std::size_t k = 0; k < block.lines; ++k)
      places.push_back(block.centre + line * (double(k) - 0.5 * (double(block.lines) - 1)));
  return places;
}

/// Names in a column beside the section, each with a line to its body.
std::string names_beside(const Frame& frame, const std::vector<Drawn>& drawn) {
  constexpr double line = 17, gap = 6;  // pixels
  std::vector<std::pair<Point, std::string>> marks;
  for (const Drawn& one : drawn) marks.emplace_back(frame(place_in(one, drawn)), one.name);
  std::sort(marks.begin(), marks.end(), [](const auto& a, const auto& b) { return a.first[1] < b.first[1]; });
  std::vector<double> wanted;
  for (const auto& mark : marks) wanted.push_back(mark.first[1]);
  const std::vector<double> places = spread(wanted, line);
  const double x = frame(frame.range.high)[0] + 3 * gap;
  std::string text;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const auto& [from, name] = marks[i];
    text += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>\n", from[0], from[1]);
    text += svg::line(from[0], from[1], x - gap / 2, places[i], "stroke=\"#000\" stroke-width=\"0.7\"");
    text += svg::text(x, places[i] + 4, "start", name, name_size);
  }
  return text;
}

/// The axis, a bar of a length to compare with, the title.
std::string frame_lines(const Frame& frame, const Scene& scene, const Panel& panel, double width) {
  const int fitting = static_cast<int>(width / (letter * double(panel.stages.size())));
  std::string text = svg::text(frame.left + width / 2, 24, "middle", panel.stages, std::min(title_size, fitting));
  if (scene.geometry == core::Geometry::axisymmetric) {
    const Point low = frame(Point(0, frame.range.low[1])), high = frame(Point(0, frame.range.high[1]));
    text += svg::line(low[0], low[1] + 8, high[0], high[1] - 8,
                      "stroke=\"#c00\" stroke-width=\"1\" stroke-dasharray=\"12 3 2 3\"");
  }
  double bar = 1e-6;  // m
  while (bar * 10 * frame.scale < width / 2) bar *= 10;
  const double x = frame.left + margin, y = title + height + 22;
  text += svg::line(x, y, x + bar * frame.scale, y, "stroke=\"#000\" stroke-width=\"2\"");
  return text + svg::text(x, y + 16, "start", fmt::format("{:g} mm", 1e3 * bar));
}

/// Width of the column of names, pixels.
double width_of_names(const Scene& scene) {
  std::size_t longest = std::string("glass").size();
  for (const forming::Tool& tool : scene.tools) longest = std::max(longest, tool.name.size());
  return letter * name_size * double(longest);
}

/// The plunger where the press ends.
std::string end_of_press(const Frame& frame, const Scene& scene, const Panel& panel) {
  const auto& plan = scene.container;
  if (!plan || !plan->press || !panel.tools.count(plan->press->tool)) return "";
  const auto outline = outline_of(scene.tools[plan->press->tool], plan->press->stop);
  return body_shape(frame, scene, outline, "fill=\"none\" stroke=\"#000\" stroke-width=\"1\" stroke-dasharray=\"5 4\"");
}

}  // namespace

std::string section_picture(const Scene& scene) {
  const Range range = range_of(scene);
  const double scale = height / (range.high - range.low).maxCoeff();
  const double width = scale * (range.high - range.low)[0] + 2 * margin + width_of_names(scene);
  const std::vector<Panel> panels = panels_of(scene);
  std::string body;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Frame frame{range, scale, static_cast<double>(i) * width};
    body += tool_shapes(frame, scene, panels[i]);
    if (i == 0)
      body += body_shape(frame, scene, outline_of(scene.glass, 0),
                         "fill=\"#f4a259\" stroke=\"#a34a00\" stroke-width=\"1\"");
    body += end_of_press(frame, scene, panels[i]) + frame_lines(frame, scene, panels[i], width) +
            names_beside(frame, drawn_in(scene, panels[i], i == 0));
  }
  const double whole = width * static_cast<double>(panels.size());
  return svg::picture(whole, title + height + 50, fmt::format("<title>{}</title>\n", scene.name) + body);
}

}  // namespace parison::tools
