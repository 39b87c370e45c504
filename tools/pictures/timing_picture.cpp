// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/io/svg.hpp"
#include "tools/pictures/pictures.hpp"

namespace parison::tools {
namespace {

namespace svg = core::svg;

using forming::Scene;
using forming::Stage;

constexpr double left = 150, width = 900, row_height = 24, top = 160;                          // pixels
constexpr std::array stage_colours{"#f4a259", "#8cb369"}, tool_colours{"#9db4c0", "#c9b8d8"};  // by cycle

/// The horizontal axis: degrees of a cycle, or seconds of the process.
struct Axis {
  double period, per_second, start;  ///< in its unit

  explicit Axis(const Scene& scene) : period(0), per_second(1), start(0) {
    for (const Stage& stage : scene.stages) period += stage.duration;
    if (!scene.timing) return;
    per_second = 360 / scene.timing->cycle;
    period = 360;
    if (const auto& timed = scene.stages.front().timed) start = timed->from;
  }
  double pixel(double at) const { return left + width * at / period; }
};

/// A part of a bar within one period, in pixels, and the period it is in.
struct Piece {
  double from, to;
  std::size_t period;
};

std::vector<Piece> pieces(const Axis& axis, double from, double to) {
  constexpr double same = 1e-6;
  const double first = axis.start + from * axis.per_second, last = axis.start + to * axis.per_second;
  std::vector<Piece> result;
  for (double k = std::floor(first / axis.period + same); k * axis.period < last - same * axis.period; ++k)
    result.push_back({axis.pixel(std::max(first - k * axis.period, 0.0)),
                      axis.pixel(std::min(last - k * axis.period, axis.period)), static_cast<std::size_t>(k)});
  return result;
}

/// Rows of bars, one below the other.
class Rows {
 public:
  explicit Rows(const Axis& axis) : axis_(axis) {}

  void begin(const std::string& name) { text_ += svg::text(left - 8, y() + 0.7 * row_height, "end", name, 13); }
  void end() { ++count_; }
  void bar(double from, double to, const std::array<const char*, 2>& colours, const std::string& name) {
    for (const Piece& piece : pieces(axis_, from, to)) {
      text_ +=
          svg::rectangle(piece.from, y() + 3, piece.to - piece.from, row_height - 6,
                         fmt::format("fill=\"{}\" stroke=\"#444\" stroke-width=\"0.6\"", colours[piece.period % 2]));
      constexpr double letter = 7;
      if (letter * static_cast<double>(name.size()) < piece.to - piece.from)
        text_ += svg::text(0.5 * (piece.from + piece.to), y() + 0.68 * row_height, "middle", name);
    }
  }
  /// A curve in a row, whose values are shares of its height.
  void curve(double from, double to, const core::TimeFunction& share) {
    constexpr int points = 60;
    for (const Piece& piece : pieces(axis_, from, to)) {
      svg::Path path;
      path.to(piece.from, y() + row_height - 3);
      const double start =
          ((piece.from - left) / width + static_cast<double>(piece.period)) * axis_.period - axis_.start;
      const double seconds = (piece.to - piece.from) / width * axis_.period / axis_.per_second;
      for (int i = 0; i <= points; ++i)
        path.to(
            piece.from + (piece.to - piece.from) * i / points,
            y() + row_height - 3 - (row_height - 6) * share(start / axis_.per_second - from + seconds * i / points));
      text_ += path.to(piece.to, y() + row_height - 3)
                   .close()
                   .drawn("fill=\"#d1495b\" fill-opacity=\"0.6\" stroke=\"#d1495b\"");
    }
  }
  double y() const { return top + row_height * count_; }
  const std::string& text() const { return text_; }

 private:
  const Axis& axis_;
  int count_ = 0;
  std::string text_;
};

template <typename Draw>
void for_each_stage(const Scene& scene, const Draw& draw) {
  double time = 0;
  for (const Stage& stage : scene.stages) {
    draw(stage, time, time + stage.duration);
    time += stage.duration;
  }
}

void add_tools(const Scene& scene, Rows& rows) {
  for (std::size_t tool = 0; tool < scene.tools.size(); ++tool) {
    rows.begin(scene.tools[tool].name);
    for_each_stage(scene, [&](const Stage& stage, double from, double to) {
      for (const forming::StageTool& entry : stage.tools)
        if (static_cast<std::size_t>(entry.tool) == tool)
          rows.bar(from, to, tool_colours, entry.moves() ? "moves" : "");
    });
    rows.end();
  }
}

void add_pressures(const Scene& scene, Rows& rows) {
  std::map<std::string, double> highest;
  for (const Stage& stage : scene.stages)
    for (const auto& [name, pressure] : stage.pressure) highest[name] = std::max(highest[name], pressure.max_size());
  for (const auto& [boundary, most] : highest) {
    if (most == 0) continue;
    rows.begin(fmt::format("{}, to {:.3g} bar", boundary, 1e-5 * most));
    for_each_stage(scene, [&, name = boundary, scale = most](const Stage& stage, double from, double to) {
      const auto found = stage.pressure.find(name);
      if (found == stage.pressure.end()) return;
      core::Table share{{}, {}};
      constexpr int points = 200;
      for (int i = 0; i <= points; ++i) {
        share.x.push_back(stage.duration * i / points);
        share.y.push_back(std::abs(found->second(share.x.back())) / scale);
      }
      rows.curve(from, to, core::TimeFunction(share));
    });
    rows.end();
  }
}

std::string tick(double x, double end, const std::string& label) {
  return svg::line(x, top, x, end, "stroke=\"#ccc\" stroke-width=\"0.8\"") +
         svg::text(x, end + 14, "middle", label, 11);
}

/// Ticks along the axis: every 30 deg with the seconds below, or ten or so round seconds.
std::string ticks(const Scene& scene, const Axis& axis, double end) {
  std::string text;
  if (scene.timing) {
    for (int angle = 0; angle <= 360; angle += 30)
      text += tick(axis.pixel(angle), end, fmt::format("{}", angle)) +
              svg::text(axis.pixel(angle), end + 28, "middle", fmt::format("{:.3g} s", angle / axis.per_second), 11,
                        "fill=\"#666\"");
    return text + svg::text(left - 8, end + 14, "end", "deg");
  }
  double step = std::pow(10, std::floor(std::log10(axis.period / 5)));
  while (axis.period / step > 16) step *= step * 5 > axis.period ? 2 : 2.5;
  for (int i = 0; i * step <= axis.period * (1 + 1e-9); ++i)
    text += tick(axis.pixel(i * step), end, fmt::format("{:g} s", i * step));
  return text;
}

std::string event_lines(const Scene& scene, const Axis& axis, double end) {
  std::string text;
  if (!scene.timing) return text;
  double last = -100;
  for (const auto& event : scene.timing->events) {
    const double x = axis.pixel(event.angle), label = std::max(x, last + 13);
    last = label;
    text += svg::Path()
                .move(label, top - 16)
                .to(x, top - 4)
                .to(x, end)
                .drawn("fill=\"none\" stroke=\"#2a6f97\" stroke-width=\"0.9\" stroke-dasharray=\"5 3\"");
    text += svg::text(
        0, 0, "start", fmt::format("{} {:g}", event.name, event.angle), 12,
        fmt::format("fill=\"#2a6f97\" transform=\"translate({:.2f} {:.1f}) rotate(-60)\"", label + 3, top - 20));
  }
  return text;
}

}  // namespace

std::string timing_picture(const Scene& scene) {
  const Axis axis(scene);
  Rows rows(axis);
  rows.begin("stages");
  for_each_stage(scene,
                 [&](const Stage& stage, double from, double to) { rows.bar(from, to, stage_colours, stage.name); });
  rows.end();
  add_tools(scene, rows);
  add_pressures(scene, rows);
  const double end = rows.y();
  const std::string title =
      scene.timing
          ? fmt::format("{}: {:.4g} cuts a minute, {} section{}, a cycle of {:.4g} s; green: in the next cycle",
                        scene.name, 60 * scene.timing->cuts, scene.timing->sections,
                        scene.timing->sections == 1 ? "" : "s", scene.timing->cycle)
          : scene.name;
  return svg::picture(
      left + width + 60, end + 45,
      svg::text(left, 22, "start", title, 15) + ticks(scene, axis, end) + rows.text() + event_lines(scene, axis, end));
}

}  // namespace parison::tools
