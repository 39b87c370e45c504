// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/solid_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/io/svg.hpp"
#include "forming/scene/container/container_plan.hpp"

namespace parison::forming {

namespace {

namespace svg = core::svg;
using core::Vector3;

constexpr double width = 900, height = 620, margin = 50;  // pixels
constexpr double view_width = 470;                        // pixels of the container, left of the curves

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

/// From thin, red, to thick, blue; distinct for eyes that do not tell red from green.
std::string colour(double share) {
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{165, 0, 38}, {244, 109, 67}, {255, 255, 191}, {116, 173, 209}, {49, 54, 149}}};
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  std::array<int, 3> mixed{};
  for (std::size_t c = 0; c < 3; ++c)
    mixed[c] =
        static_cast<int>(std::lround(stops[first][c] + (at - double(first)) * (stops[first + 1][c] - stops[first][c])));
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

/// The place of a point of the sector in its copy of a number, around the whole turn.
Vector3 in_copy(const Vector3& at, long copy, double sector) {
  const double radius = std::hypot(at[0], at[1]), angle = std::atan2(at[1], at[0]);
  const double turned = copy % 2 == 0 ? angle + double(copy) * sector : double(copy + 1) * sector - angle;
  return {radius * std::cos(turned), radius * std::sin(turned), at[2]};
}

/// A piece of the outer side as it is seen.
struct Piece {
  std::array<std::array<double, 2>, 4> corners;  ///< m
  double depth;                                  ///< m, greater in front
  double thickness;                              ///< m
  double light;                                  ///< 0 to 1
};

class View {
 public:
  View(const Scene& scene, const SolidState& solid, const SolidWall& wall)
      : up_(is_upright(scene, scene.stages.size() - 1) ? 1 : -1) {
    std::vector<double> thickness(static_cast<std::size_t>(solid.glass.mesh.node_count()), 0);
    for (const SolidWallPoint& point : wall.points) thickness[static_cast<std::size_t>(point.outer)] = point.thickness;
    const long copies = std::lround(2 * M_PI / scene.solid->sector);
    for (std::size_t f = 0; f < solid.faces.size(); ++f)
      if (solid.heat_faces[f].boundary_id == static_cast<Index>(SolidSide::outer))
        for (long copy = 0; copy < copies; ++copy)
          add_face(solid, solid.heat_faces[f], copy, scene.solid->sector, thickness);
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.depth < b.depth; });
  }

  std::string drawn(const Range& colours) const {
    Range x, y;
    for (const Piece& piece : pieces_)
      for (const auto& corner : piece.corners) x.add(corner[0]), y.add(corner[1]);
    const double scale =
        std::min((view_width - 2 * margin) / (x.high - x.low), (height - 2 * margin) / (y.high - y.low));
    std::string text;
    for (const Piece& piece : pieces_) {
      svg::Path path;
      for (const auto& corner : piece.corners)
        path.to(margin + (corner[0] - x.low) * scale, height - margin - (corner[1] - y.low) * scale);
      const std::string fill = colour(colours.share(piece.thickness));
      text += path.close().drawn(fmt::format(R"(fill="{}" stroke="{}" stroke-width="0.4")", fill, fill));
      if (piece.light < 1)
        text += path.drawn(fmt::format(R"(fill="black" fill-opacity="{:.2f}")", 0.45 * (1 - piece.light)));
    }
    return text;
  }

 private:
  void add_face(const SolidState& solid, const core::QuadFace& face, long copy, double sector,
                const std::vector<double>& thickness) {
    constexpr double azimuth = 0.45, tilt = 0.3;  // rad
    const auto seen = [&](const Vector3& at) {
      const Vector3 turned(at[0] * std::cos(azimuth) - at[1] * std::sin(azimuth),
                           at[0] * std::sin(azimuth) + at[1] * std::cos(azimuth), up_ * at[2]);
      return Vector3(turned[0], turned[2] * std::cos(tilt) + turned[1] * std::sin(tilt),
                     -turned[1] * std::cos(tilt) + turned[2] * std::sin(tilt));
    };
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        const std::array<int, 4> local{i + 3 * j, i + 1 + 3 * j, i + 1 + 3 * (j + 1), i + 3 * (j + 1)};
        Piece piece{};
        std::array<Vector3, 4> corner;
        for (std::size_t c = 0; c < 4; ++c) {
          const Index node = face.nodes[static_cast<std::size_t>(local[c])];
          corner[c] = seen(in_copy(solid.glass.mesh.nodes[node], copy, sector));
          piece.corners[c] = {corner[c][0], corner[c][1]};
          piece.depth += 0.25 * corner[c][2];
          piece.thickness += 0.25 * thickness[static_cast<std::size_t>(node)];
        }
        const Vector3 across = (corner[2] - corner[0]).cross(corner[3] - corner[1]);
        if (across.norm() > 0) piece.light = std::abs(across[2]) / across.norm();
        pieces_.push_back(piece);
      }
  }

  double up_;
  std::vector<Piece> pieces_;
};

/// Thickness over the height: in bands of the height the least and the greatest one of some points.
struct Curve {
  const char *name, *style;
  std::vector<std::array<double, 2>> points;  ///< height, thickness, m
};

Curve curve_of(const char* name, const char* style, const SolidWall& wall, const Range& heights, double angle,
               bool thinnest) {
  constexpr int bands = 60;
  constexpr double same_angle = 0.02;  // rad
  Curve curve{name, style, {}};
  for (int band = 0; band < bands; ++band) {
    double thickness = std::numeric_limits<double>::infinity();
    const double low = heights.low + (heights.high - heights.low) * band / bands;
    const double high = heights.low + (heights.high - heights.low) * (band + 1) / bands;
    for (const SolidWallPoint& point : wall.points) {
      const bool is_on = thinnest || std::abs(std::atan2(point.at[1], point.at[0]) - angle) < same_angle;
      if (is_on && point.at[2] >= low && point.at[2] <= high && std::hypot(point.at[0], point.at[1]) > 0)
        thickness = std::min(thickness, point.thickness);
    }
    if (std::isfinite(thickness)) curve.points.push_back({0.5 * (low + high), thickness});
  }
  return curve;
}

std::string drawn_curves(const std::vector<Curve>& curves, const Range& heights, double thickest, double up) {
  const double left = view_width + margin, right = width - margin, top = margin + 60, bottom = height - margin;
  const auto x = [&](double thickness) { return left + (right - left) * thickness / thickest; };
  const auto y = [&](double z) {
    const double share = heights.share(z);
    return bottom - (bottom - top) * (up > 0 ? share : 1 - share);
  };
  std::string text = svg::line(left, top, left, bottom, R"(stroke="black")") +
                     svg::line(left, bottom, right, bottom, R"(stroke="black")");
  const double tick = thickest > 8e-3 ? 2e-3 : 1e-3;
  for (double t = 0; t <= thickest; t += tick)
    text += svg::line(x(t), bottom, x(t), bottom + 5, R"(stroke="black")") +
            svg::text(x(t), bottom + 20, "middle", fmt::format("{:.0f}", 1e3 * t));
  text += svg::text(0.5 * (left + right), bottom + 40, "middle", "wall, mm");
  constexpr double height_tick = 20e-3;
  for (double z = std::ceil(heights.low / height_tick - 1e-6) * height_tick; z <= heights.high; z += height_tick)
    text += svg::line(left - 5, y(z), left, y(z), R"(stroke="black")") +
            svg::text(left - 8, y(z) + 4, "end", fmt::format("{:.0f}", 1e3 * z + 0.0));
  double legend = margin;
  for (const Curve& curve : curves) {
    svg::Path path;
    for (const auto& [z, thickness] : curve.points) path.to(x(thickness), y(z));
    text += path.drawn(fmt::format(R"(fill="none" stroke-width="2" {})", curve.style));
    text += svg::line(left, legend, left + 30, legend, fmt::format(R"(stroke-width="2" {})", curve.style)) +
            svg::text(left + 38, legend + 4, "start", curve.name);
    legend += 18;
  }
  return text;
}

std::string colour_bar(const Range& colours) {
  std::string text;
  constexpr int steps = 40;
  constexpr double left = margin, bar = 200, top = 18;
  for (int i = 0; i < steps; ++i)
    text += svg::rectangle(left + bar * i / steps, top, bar / steps + 0.5, 10,
                           fmt::format(R"(fill="{}")", colour((i + 0.5) / steps)));
  return text + svg::text(left - 6, top + 10, "end", fmt::format("{:.1f}", 1e3 * colours.low)) +
         svg::text(left + bar + 6, top + 10, "start", fmt::format("{:.1f} mm", 1e3 * colours.high));
}

}  // namespace

std::string solid_picture(const Scene& scene, const SolidState& solid, const SolidWall& wall) {
  Range heights;
  std::vector<double> sorted;
  for (const SolidWallPoint& point : wall.points) heights.add(point.at[2]), sorted.push_back(point.thickness);
  std::sort(sorted.begin(), sorted.end());
  constexpr double left_out = 0.02;  // of the points, at each end of the colours
  const auto end = static_cast<std::size_t>(left_out * double(sorted.size()));
  const Range colours{sorted[end], sorted[sorted.size() - 1 - end]};
  const double up = is_upright(scene, scene.stages.size() - 1) ? 1 : -1;
  const std::vector<Curve> curves{
      curve_of("in the plane y = 0", R"(stroke="#1f6fb4")", wall, heights, 0, false),
      curve_of("at the other end of the sector", R"(stroke="#8a8a8a" stroke-dasharray="6 3")", wall, heights,
               std::min(scene.solid->sector, M_PI), false),
      curve_of("thinnest around", R"(stroke="#c0392b")", wall, heights, 0, true)};
  return svg::picture(width, height,
                      View(scene, solid, wall).drawn(colours) + colour_bar(colours) +
                          drawn_curves(curves, heights, 1.05 * sorted.back(), up));
}

}  // namespace parison::forming
