#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// A DXF file written in the ways of several CAD programs.
#include <algorithm>
#include <functional>
#include <utility>

#include "drawn_outline.hpp"

namespace parison::tests {

/// Text of entities, every number by one format and in one unit.
class DxfWriter {
 public:
  double unit = 1;           ///< mm
  int decimals = 15;         ///< 15: all that count
  std::string layer = "0";   ///< of what follows
  bool from_behind = false;  ///< planes of the entities have the direction (0, 0, -1)
  std::string text;

  void group(int code, const std::string& value) { text += fmt::format("{:3}\n{}\n", code, value); }
  void group(int code, double value) {
    group(code, decimals < 15 ? fmt::format("{:.{}f}", value, decimals) : fmt::format("{:.15g}", value));
  }
  void begin(const std::string& kind) {
    group(0, kind);
    group(8, layer);
    if (from_behind && kind != "LINE" && kind != "VERTEX" && kind != "SEQEND") group(230, -1.0);
  }
  /// A place; in its own plane that looks backwards, x runs to the left.
  void place(int code, const Point& x, bool in_own_plane = false) {
    group(code, (from_behind && in_own_plane ? -1 : 1) * x[0] / unit);
    group(code + 10, x[1] / unit);
  }

  void line(const Point& a, const Point& b) {
    begin("LINE");
    place(10, a);
    place(11, b);
  }
  /// Of a side with a bulge, always counterclockwise in its own plane.
  void arc(const Point& a, const Point& b, double bulge) {
    const Point along = b - a, left(-along[1], along[0]);
    const Point centre = 0.5 * (a + b) + (1 - bulge * bulge) / (4 * bulge) * left;
    const auto angle = [&](const Point& x) {
      const double own = std::atan2(x[1] - centre[1], (from_behind ? -1 : 1) * (x[0] - centre[0])) * 180 / M_PI;
      return own < 0 ? own + 360 : own;
    };
    const bool forward = (bulge > 0) != from_behind;
    begin("ARC");
    place(10, centre, true);
    group(40, (a - centre).norm() / unit);
    group(50, angle(forward ? a : b));
    group(51, angle(forward ? b : a));
  }
  void side(const Corner& a, const Point& b) { a.bulge == 0 ? line(a.x, b) : arc(a.x, b, a.bulge); }

  void light_polyline(const Outline& outline) {
    begin("LWPOLYLINE");
    group(90, std::to_string(outline.size()));
    group(70, "1");
    for (const Corner& corner : outline) {
      place(10, corner.x, true);
      if (corner.bulge != 0) group(42, from_behind ? -corner.bulge : corner.bulge);
    }
  }
  void old_polyline(const Outline& outline) {
    begin("POLYLINE");
    group(66, "1");
    group(70, "1");
    for (const Corner& corner : outline) {
      begin("VERTEX");
      place(10, corner.x, true);
      if (corner.bulge != 0) group(42, from_behind ? -corner.bulge : corner.bulge);
    }
    begin("SEQEND");
  }
  /// Sides in any order and direction.
  void soup(const Outline& outline, std::mt19937& random) {
    std::vector<std::pair<Corner, Point>> sides;
    for (std::size_t i = 0; i < outline.size(); ++i)
      sides.emplace_back(outline[i], outline[(i + 1) % outline.size()].x);
    std::shuffle(sides.begin(), sides.end(), random);
    for (const auto& [a, b] : sides)
      if (a.bulge == 0 && random() % 2)
        line(b, a.x);
      else
        side(a, b);
  }
};

inline std::string section(const std::string& name, const std::string& content) {
  return fmt::format("  0\nSECTION\n  2\n{}\n{}  0\nENDSEC\n", name, content);
}

/// A whole file of what is drawn, with the variables of the header as "9\n$NAME\ncode\nvalue\n".
inline std::string dxf_of(const std::string& entities, const std::string& variables = "",
                          const std::string& tables = "", const std::string& blocks = "") {
  std::string text;
  if (!variables.empty()) text += section("HEADER", variables);
  if (!tables.empty()) text += section("TABLES", tables);
  if (!blocks.empty()) text += section("BLOCKS", blocks);
  return text + section("ENTITIES", entities) + "  0\nEOF\n";
}

/// Draws random outlines and expects the area of each within `share` of it.
inline void expect_areas(const std::function<Taken(const Outline&, std::mt19937&)>& draw, bool with_arcs = true,
                         double share = 1e-5) {
  std::mt19937 random(54);
  for (int i = 0; i < 20; ++i) {
    const Outline outline = random_outline(random, with_arcs);
    const Taken taken = draw(outline, random);
    ASSERT_EQ(taken.refusal, "") << "outline " << i;
    ASSERT_NEAR(taken.area / area_of(outline), 1, share) << "outline " << i;
  }
}

}  // namespace parison::tests
