// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/svg.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::forming {
namespace {

namespace svg = core::svg;

constexpr double plot_width = 760, left = 70, right = 20, wall_height = 280, change_height = 240, gap = 56, top = 44;
/// Apart from each other for colour-blind readers too (M. Okabe, K. Ito, Color universal design, 2008).
constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
constexpr const char* base_colour = "#222222";

using Profile = std::vector<double>;

/// From shares of the arc and mm to pixels.
struct Frame {
  double low, high, above, height;
  double x(double share) const { return left + plot_width * share; }
  double y(double value) const { return above + height * (high - value) / (high - low); }
};

/// The steps of an axis: 1, 2 or 5 times a power of ten, about five of them.
double tick_step(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  const double lead = rough / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

std::string axes(const Frame& frame, const std::string& title) {
  std::string drawn;
  const double step = tick_step(frame.high - frame.low);
  for (double value = step * std::ceil(frame.low / step - 1e-9); value <= frame.high + 1e-9 * step; value += step) {
    const double tidy = std::abs(value) < 1e-9 * step ? 0 : value;
    drawn += svg::line(left, frame.y(tidy), left + plot_width, frame.y(tidy),
                       tidy == 0 ? "stroke=\"#888\"" : "stroke=\"#e4e4e4\"");
    drawn += svg::text(left - 6, frame.y(tidy) + 4, "end", fmt::format("{:.4g}", tidy));
  }
  for (int i = 0; i <= 10; i += 2)
    drawn += svg::text(frame.x(0.1 * i), frame.above + frame.height + 16, "middle", fmt::format("{:.1f}", 0.1 * i));
  drawn += svg::rectangle(left, frame.above, plot_width, frame.height, "fill=\"none\" stroke=\"#888\"");
  return drawn + svg::text(left, frame.above - 8, "start", title, 13);
}

/// A line, broken where there is no wall.
std::string line(const Frame& frame, const Profile& values, const std::string& style) {
  svg::Path path;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const double x = frame.x(double(i) / double(values.size() - 1)),
                 y = frame.y(std::clamp(values[i], frame.low, frame.high));
    if (i > 0 && std::isfinite(values[i - 1]))
      path.to(x, y);
    else
      path.move(x, y);
  }
  return path.drawn("fill=\"none\" " + style);
}

/// The band of a difference with its error bar, place by place.
std::string band(const Frame& frame, const ProfileComparison& walls, const char* colour) {
  svg::Path path;
  const auto shown = [&](std::size_t i, double sign) {
    return frame.y(std::clamp(walls.difference[i] + sign * walls.bar[i], frame.low, frame.high));
  };
  const double count = double(walls.bar.size() - 1);
  for (std::size_t i = 1; i < walls.bar.size(); ++i)
    if (std::isfinite(walls.bar[i]) && std::isfinite(walls.bar[i - 1]))
      path.move(frame.x(double(i - 1) / count), shown(i - 1, 1))
          .to(frame.x(double(i) / count), shown(i, 1))
          .to(frame.x(double(i) / count), shown(i, -1))
          .to(frame.x(double(i - 1) / count), shown(i - 1, -1))
          .close();
  return path.drawn(fmt::format("fill=\"{}\" fill-opacity=\"0.18\"", colour));
}

void widen(double& low, double& high, const Profile& values) {
  for (const double value : values)
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
}

/// The range of the differences: what nineteen of twenty places stay within, since the wall jumps where it ends.
double usual_size(const std::vector<const ComparedRun*>& runs) {
  std::vector<double> sizes;
  for (const ComparedRun* run : runs)
    for (const double value : run->result->profile.difference)
      if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return 1;
  std::sort(sizes.begin(), sizes.end());
  const double usual = 1.6 * sizes[sizes.size() * 19 / 20];
  return usual > 0 ? usual : 1;
}

std::string style_of(std::size_t run) {
  return fmt::format("stroke=\"{}\" stroke-width=\"1.8\"{}", colours[run % colours.size()],
                     run >= colours.size() ? " stroke-dasharray=\"6 3\"" : "");
}

std::string legend(const std::vector<const ComparedRun*>& runs, const std::string& base, double y) {
  std::string drawn;
  const auto entry = [&](const std::string& style, const std::string& label) {
    drawn += svg::line(left, y, left + 28, y, style);
    drawn += svg::text(left + 36, y + 4, "start", label);
    y += 18;
  };
  entry(fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", base_colour), base);
  for (std::size_t i = 0; i < runs.size(); ++i) entry(style_of(i), runs[i]->label);
  return drawn;
}

}  // namespace

std::string profile_plot(const Comparison& comparison) {
  std::vector<const ComparedRun*> runs;
  for (const ComparedRun& other : comparison.others)
    if (other.result && !other.result->profile.difference.empty()) runs.push_back(&other);
  const Profile& base = comparison.base.quantities.profile;
  if (base.empty() || runs.empty()) return "";
  double low = 0, high = 0;
  widen(low, high, base);
  for (const ComparedRun* run : runs) widen(low, high, run->result->profile.other);
  const double change = usual_size(runs), second = top + wall_height + gap, end = second + change_height + 44;
  const Frame wall{low, 1.05 * high, top, wall_height}, difference{-change, change, second, change_height};
  std::string drawn = axes(wall, "wall thickness, mm") +
                      axes(difference, fmt::format("difference from {}, mm, with error bars", comparison.base.name));
  for (std::size_t i = 0; i < runs.size(); ++i)
    drawn += band(difference, runs[i]->result->profile, colours[i % colours.size()]);
  drawn += line(wall, base, fmt::format("stroke=\"{}\" stroke-width=\"1.8\"", base_colour));
  for (std::size_t i = 0; i < runs.size(); ++i)
    drawn += line(wall, runs[i]->result->profile.other, style_of(i)) +
             line(difference, runs[i]->result->profile.difference, style_of(i));
  drawn += svg::text(left + 0.5 * plot_width, second + change_height + 34, "middle", "share of the outer arc");
  drawn += legend(runs, comparison.base.name, end + 14);
  return svg::picture(left + plot_width + right, end + 18.0 * double(runs.size() + 1) + 14, drawn, "fill=\"#222\"");
}

}  // namespace parison::forming
