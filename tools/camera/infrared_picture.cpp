// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "core/io/svg.hpp"
#include "tools/camera/camera.hpp"

namespace parison::tools {

namespace {

namespace svg = core::svg;

constexpr double margin = 50, scale_width = 90, scale_height = 240, top = 70;  // pixels of the picture
constexpr double wanted_height = 560;                                          // of an image
constexpr int shades = 64;

/// A fill from black over red and yellow to white, as hot bodies look.
std::string fill(int shade) {
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{12, 8, 38}, {110, 22, 95}, {205, 62, 58}, {248, 158, 42}, {252, 250, 210}}};
  const double at = (static_cast<double>(stops.size()) - 1) * shade / (shades - 1);
  const auto first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  std::array<int, 3> rgb{};
  for (int i = 0; i < 3; ++i)
    rgb[i] = static_cast<int>(
        std::lround(stops[first][i] + (at - static_cast<double>(first)) * (stops[first + 1][i] - stops[first][i])));
  return fmt::format("fill=\"#{:02x}{:02x}{:02x}\"", rgb[0], rgb[1], rgb[2]);
}

/// Temperatures of the darkest and the brightest colour, degC.
struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  int shade(double value) const {
    if (!(high > low)) return shades / 2;
    return std::clamp(static_cast<int>(shades * (value - low) / (high - low)), 0, shades - 1);
  }
};

bool is_glass(const InfraredImage& image, std::size_t row, std::size_t column) {
  return row < image.rows.size() && column < image.rows[row].size() && !std::isnan(image.rows[row][column]);
}

/// Whether the pixels beside, above and below one show glass too; the image goes on beyond the axis.
bool is_inside(const InfraredImage& image, std::size_t row, std::size_t column) {
  return row > 0 && is_glass(image, row - 1, column) && is_glass(image, row + 1, column) &&
         is_glass(image, row, column + 1) && is_glass(image, row, column) &&
         (column == 0 || is_glass(image, row, column - 1));
}

Span span_of(const InfraredImage& image) {
  Span inside, all;
  const auto include = [](double value, Span& span) {
    span.low = std::min(span.low, value);
    span.high = std::max(span.high, value);
  };
  for (std::size_t j = 0; j < image.rows.size(); ++j)
    for (std::size_t i = 0; i < image.rows[j].size(); ++i) {
      if (is_glass(image, j, i)) include(image.rows[j][i], all);
      if (is_inside(image, j, i)) include(image.rows[j][i], inside);
    }
  return inside.high > inside.low ? inside : all;
}

/// Pixels of one shade beside each other are one rectangle, on both sides of the axis.
std::string row_of(const std::vector<double>& row, const Span& span, double axis, double y, double size) {
  const auto shade_at = [&](std::size_t i) { return i >= row.size() || std::isnan(row[i]) ? -1 : span.shade(row[i]); };
  std::string text;
  for (std::size_t i = 0; i < row.size();) {
    std::size_t end = i + 1;
    while (end < row.size() && shade_at(end) == shade_at(i)) ++end;
    if (const int shade = shade_at(i); shade >= 0)
      for (const double from : {axis + size * static_cast<double>(i), axis - size * static_cast<double>(end)})
        text += svg::rectangle(from, y, size * static_cast<double>(end - i) + 0.05, size + 0.05, fill(shade));
    i = end;
  }
  return text;
}

std::string scale_of(const Span& span, double x) {
  std::string text;
  const double step = scale_height / shades;
  for (int i = 0; i < shades; ++i)
    text += svg::rectangle(x, top + scale_height - (i + 1) * step, 16, step + 0.1, fill(i));
  for (int i = 0; i <= 4; ++i)
    text += svg::text(x + 20, top + scale_height * (1 - i / 4.0) + 4, "start",
                      fmt::format("{:.0f} degC", span.low + i / 4.0 * (span.high - span.low)));
  return text;
}

}  // namespace

std::string infrared_picture(const std::vector<InfraredImage>& images, const std::string& caption) {
  std::string text;
  double x = margin, height = top;
  for (const InfraredImage& image : images) {
    const Span span = span_of(image);
    std::size_t widest = 0;
    for (const auto& row : image.rows) widest = std::max(widest, row.size());
    const double size = wanted_height / static_cast<double>(image.rows.size());
    const double half = size * static_cast<double>(widest), axis = x + std::max(half, 100.0);
    text += svg::text(x, top - 14, "start", image.title, 14);
    for (std::size_t j = 0; j < image.rows.size(); ++j) {
      const std::size_t from_top = image.upright ? image.rows.size() - 1 - j : j;
      text += row_of(image.rows[j], span, axis, top + size * static_cast<double>(from_top), size);
    }
    x = axis + std::max(half, 100.0) + 16;
    text += scale_of(span, x);
    x += scale_width + margin;
    height = std::max(height, top + wanted_height);
  }
  return svg::picture(x, height + margin, svg::text(margin, 28, "start", caption, 16) + text,
                      "shape-rendering=\"crispEdges\"");
}

}  // namespace parison::tools
