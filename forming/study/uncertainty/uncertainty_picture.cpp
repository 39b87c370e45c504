// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/svg.hpp"
#include "core/math/numbers.hpp"
#include "forming/study/uncertainty/uncertainty.hpp"

namespace parison::forming {
namespace {

namespace svg = core::svg;

constexpr double width = 900, left = 300, right = 40, row_height = 24, wall_height = 240;
/// Apart from each other for colour-blind readers too (M. Okabe, K. Ito, Color universal design, 2008).
constexpr const char *bar_colour = "#0072B2", *part_colour = "#56B4E9", *wall_colour = "#D55E00";

double span() {
  return width - left - right;
}

/// A picture that grows downwards.
struct Page {
  std::string drawn;
  double y = 30;
};

/// The total indices as bars with their intervals, the part of the tolerance alone darker.
void draw_ranking(const UncertaintyPlan& plan, const Ranking& ranking, Page& page) {
  page.drawn += svg::text(20, page.y, "start", "What to measure first", 16, "font-weight=\"bold\"");
  page.drawn +=
      svg::text(20, page.y + 18, "start",
                fmt::format("share of the variance of {} that each tolerance makes: alone (dark), with others "
                            "(light), 95 % intervals",
                            ranking.of));
  page.y += 34;
  const double top = page.y;
  for (const std::size_t i : ranking.order) {
    const Interval &first = ranking.indices.first[i], &total = ranking.indices.total[i];
    const double middle = page.y + 0.5 * row_height;
    page.drawn += svg::text(left - 10, middle + 4, "end", plan.tolerances[i].key);
    if (std::isfinite(total.value)) {
      page.drawn += svg::rectangle(left, page.y + 4, span() * total.value, row_height - 8,
                                   fmt::format("fill=\"{}\"", part_colour));
      page.drawn += svg::rectangle(left, page.y + 4, span() * first.value, row_height - 8,
                                   fmt::format("fill=\"{}\"", bar_colour));
    }
    page.drawn += svg::line(left + span() * total.low, middle, left + span() * total.high, middle,
                            "stroke=\"#222\" stroke-width=\"1.5\"");
    for (const double end : {total.low, total.high})
      page.drawn += svg::line(left + span() * end, middle - 5, left + span() * end, middle + 5,
                              "stroke=\"#222\" stroke-width=\"1.5\"");
    page.y += row_height;
  }
  for (int i = 0; i <= 10; i += 2) {
    const double x = left + 0.1 * i * span();
    page.drawn += svg::line(x, top, x, page.y, "stroke=\"#888\" stroke-opacity=\"0.3\"");
    page.drawn += svg::text(x, page.y + 14, "middle", fmt::format("{:.1f}", 0.1 * i));
  }
  page.y += 50;
}

std::string bar_text(double bar) {
  return std::isfinite(bar) ? fmt::format("{:.2g}", bar) : "-";
}

/// A cell whose darkness is the index.
std::string index_cell(double x, double y, double w, const Interval& index) {
  const double share = std::isfinite(index.value) ? index.value : 0;
  return svg::rectangle(x, y, w, row_height,
                        fmt::format("fill=\"{}\" fill-opacity=\"{:.2f}\" stroke=\"#ddd\"", bar_colour, share)) +
         svg::text(x + 0.5 * w, y + 16, "middle", std::isfinite(index.value) ? fmt::format("{:.2f}", share) : "?", 11,
                   share > 0.6 ? "fill=\"white\"" : "");
}

/// Total indices of all quantities, a column a tolerance in the order of the ranking.
void draw_indices(const UncertaintyPlan& plan, const UncertaintyResult& result, const Ranking& ranking, Page& page) {
  const double bars = 270, cell = std::min(90.0, (span() - bars) / double(ranking.order.size()));
  page.drawn +=
      svg::text(20, page.y, "start", "Quantities: total index of each tolerance (?: no effect above the noise)", 14,
                "font-weight=\"bold\"");
  page.y += 20;
  for (std::size_t column = 0; column < ranking.order.size(); ++column)
    page.drawn += svg::text(left + bars + cell * (double(column) + 0.5), page.y, "middle",
                            fmt::format("{}", column + 1), 12, "font-weight=\"bold\"");
  page.drawn += svg::text(left + bars - 10, page.y, "end", "value, bars: numerical, tolerances, both");
  page.y += 8;
  for (const UncertainQuantity& quantity : result.quantities) {
    const bool poor = has_effect(quantity.effects) && quantity.effects.q2() < good_q2;
    page.drawn += svg::text(left - 10, page.y + 16, "end", quantity.name + (poor ? " *" : ""));
    page.drawn +=
        svg::text(left + bars - 10, page.y + 16, "end",
                  fmt::format("{:.4g} {}:  {}  {}  {}", quantity.at_mean, quantity.unit, bar_text(quantity.numerical),
                              bar_text(quantity.tolerance_bar()), bar_text(quantity.bar())));
    const SobolIndices indices = sobol_indices(quantity.effects);
    for (std::size_t column = 0; column < ranking.order.size(); ++column)
      page.drawn += index_cell(left + bars + cell * double(column), page.y, cell, indices.total[ranking.order[column]]);
    page.y += row_height;
  }
  page.y += 18;
  std::string keys;
  for (std::size_t column = 0; column < ranking.order.size(); ++column)
    keys += fmt::format("{}{} {}", column > 0 ? ", " : "", column + 1, plan.tolerances[ranking.order[column]].key);
  page.drawn += svg::text(20, page.y, "start", keys, 11);
  page.y += 16;
  page.drawn += svg::text(
      20, page.y, "start",
      fmt::format("* the surrogate explains less than {:.0f} % of runs that it has not seen", 100 * good_q2), 11);
  page.y += 40;
}

/// From shares of the profile and mm to pixels.
struct Frame {
  double top, highest;
  double x(double share) const { return 80 + share * (width - 80 - right); }
  double y(double thickness) const { return top + wall_height * (1 - thickness / highest); }
};

/// A band about the wall, place by place; broken where the wall is.
std::string band(const UncertaintyResult& result, const Frame& frame, double (*bar)(const UncertainQuantity&),
                 const std::string& style) {
  svg::Path path;
  for (std::size_t i = 1; i < result.wall.size(); ++i) {
    const UncertainPlace &a = result.wall[i - 1], &b = result.wall[i];
    if (b.along - a.along > 0.02 || b.share < a.share) continue;  // the next meridian
    const double x1 = frame.x(a.along), x2 = frame.x(b.along), at1 = a.thickness.at_mean, at2 = b.thickness.at_mean;
    path.move(x1, frame.y(at1 + bar(a.thickness)))
        .to(x2, frame.y(at2 + bar(b.thickness)))
        .to(x2, frame.y(std::max(0.0, at2 - bar(b.thickness))))
        .to(x1, frame.y(std::max(0.0, at1 - bar(a.thickness))))
        .close();
  }
  return path.drawn(style);
}

double numerical_of(const UncertainQuantity& quantity) {
  return std::isfinite(quantity.numerical) ? quantity.numerical : 0;
}

double both_of(const UncertainQuantity& quantity) {
  return quantity.bar();
}

double none_of(const UncertainQuantity&) {
  return 0;
}

/// Below the wall: shares of the outer arc; in space the planes whose meridians follow each other.
void draw_places(const UncertaintyResult& result, const Frame& frame, Page& page) {
  const double y = frame.y(0) + 16;
  double angle = core::none;
  for (const UncertainPlace& place : result.wall)
    if (std::isfinite(place.angle) && place.angle != angle) {
      angle = place.angle;
      page.drawn += svg::line(frame.x(place.along), frame.y(0), frame.x(place.along), frame.top, "stroke=\"#e4e4e4\"");
      page.drawn += svg::text(frame.x(place.along), y, "start", fmt::format("{:g} deg: axis to rim", angle));
    }
  for (int i = 0; std::isnan(angle) && i <= 10; i += 2)
    page.drawn += svg::text(frame.x(0.1 * i), y, "middle", fmt::format("{:.1f}", 0.1 * i));
}

void draw_wall(const UncertaintyResult& result, Page& page) {
  const bool in_space = std::isfinite(result.wall.front().angle);
  page.drawn += svg::text(20, page.y, "start",
                          in_space ? "Wall thickness, mm, along the outer side in planes through the axis"
                                   : "Wall thickness, mm, over the share of the outer arc",
                          14, "font-weight=\"bold\"");
  page.drawn += svg::text(20, page.y + 17, "start",
                          "light: tolerances (two standard deviations) and numerics together; dark: numerics alone");
  std::vector<double> heights;
  for (const UncertainPlace& place : result.wall) heights.push_back(place.thickness.at_mean + place.thickness.bar());
  std::sort(heights.begin(), heights.end());
  const Frame frame{page.y + 30, 1.15 * heights[heights.size() * 97 / 100]};
  for (int i = 0; i <= 4; ++i) {
    const double at = 0.25 * i * frame.highest;
    page.drawn += svg::line(frame.x(0), frame.y(at), frame.x(1), frame.y(at), "stroke=\"#e4e4e4\"");
    page.drawn += svg::text(frame.x(0) - 8, frame.y(at) + 4, "end", fmt::format("{:.3g}", at));
  }
  draw_places(result, frame, page);
  page.drawn += "<clipPath id=\"wall\">" +
                svg::rectangle(frame.x(0), frame.top, frame.x(1) - frame.x(0), wall_height, "") +
                "</clipPath>\n<g clip-path=\"url(#wall)\">\n";
  page.drawn += band(result, frame, both_of, fmt::format("fill=\"{}\" fill-opacity=\"0.25\"", wall_colour));
  page.drawn += band(result, frame, numerical_of, fmt::format("fill=\"{}\" fill-opacity=\"0.5\"", wall_colour));
  page.drawn += band(result, frame, none_of, "fill=\"none\" stroke=\"#222\" stroke-width=\"1.5\"") + "</g>\n";
  page.y = frame.y(0) + 40;
}

}  // namespace

std::string uncertainty_picture(const UncertaintyPlan& plan, const UncertaintyResult& result) {
  const Ranking ranking = measure_first(plan, result);
  Page page;
  draw_ranking(plan, ranking, page);
  draw_indices(plan, result, ranking, page);
  if (!result.wall.empty()) draw_wall(result, page);
  return svg::picture(width, page.y, page.drawn, "fill=\"#222\"");
}

}  // namespace parison::forming
