#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Random closed outlines with an area that is known exactly, for what reads drawings.
#include <fmt/core.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/io/files.hpp"
#include "core/mesh/profile.hpp"
#include "forming/scene/read/drawing/read_section.hpp"
#include "test_folder.hpp"

namespace parison::tests {

using core::Point;

/// A corner of an outline; the bulge of the side behind it is the tangent of a quarter of the angle that it turns.
struct Corner {
  Point x;  ///< mm
  double bulge = 0;
};
using Outline = std::vector<Corner>;

/// Counterclockwise around (40, 50) mm; every second side is an arc.
inline Outline random_outline(std::mt19937& random, bool with_arcs = true) {
  std::uniform_real_distribution<double> part(0, 1);
  const int count = 6 + static_cast<int>(part(random) * 5);
  Outline outline;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * (i + 0.6 * part(random)) / count, radius = 15 + 15 * part(random);
    const double bulge = with_arcs && i % 2 ? 0.5 * part(random) - 0.2 : 0;
    outline.push_back({{40 + radius * std::cos(angle), 50 + radius * std::sin(angle)}, bulge});
  }
  return outline;
}

/// What an arc adds to the area on the left of its chord, mm2.
inline double area_of_arc(const Point& start, const Point& end, double bulge) {
  if (bulge == 0) return 0;
  const double turn = 4 * std::atan(bulge), radius = (end - start).norm() / (2 * std::sin(0.5 * turn));
  return 0.5 * radius * radius * (turn - std::sin(turn));
}

/// mm2.
inline double area_of(const Outline& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point &a = outline[i].x, &b = outline[(i + 1) % outline.size()].x;
    area += 0.5 * core::cross(a, b) + area_of_arc(a, b, outline[i].bulge);
  }
  return area;
}

/// What a curve over 0 to 1 adds to the area on the left of its chord, mm2: parabolas through three places each.
template <typename Curve>
double area_of_curve(const Curve& curve) {
  constexpr int parts = 4000;
  double area = 0;
  Point last = curve(0.0);
  const Point first = last;
  for (int i = 1; i <= parts; ++i) {
    const Point middle = curve((i - 0.5) / parts), next = curve(double(i) / parts);
    area += (2 * (core::cross(last, middle) + core::cross(middle, next)) - 0.5 * core::cross(last, next)) / 3;
    last = next;
  }
  return area - 0.5 * core::cross(first, last);
}

/// The area that a drawing of these keys encloses, mm2; a sentence where it is refused.
struct Taken {
  double area = 0;
  std::string refusal;
  std::vector<std::string> notes;
  std::size_t curves = 0;
};
inline Taken take(const std::string& name, const std::string& content, const std::string& keys) {
  Taken taken;
  const std::string folder = folder_of_test("drawing").string();
  std::filesystem::create_directories(folder);
  if (!content.empty()) core::write_text(folder + "/" + name, content);
  try {
    core::CaseNode place;
    const auto node = core::parse_value(fmt::format("{{ file = \"{}\", {} }}", name, keys), place);
    const core::Profile profile{forming::read_section(node, folder, taken.notes), {}};
    taken.curves = profile.segments.size();
    taken.area = 1e6 * std::abs(core::signed_area(profile));
  } catch (const core::CaseError& error) {
    taken.refusal = error.what();
  }
  return taken;
}

/// "from = "(1, 2) mm"".
inline std::string from(const Point& x) {
  return fmt::format("from = \"({:.9g}, {:.9g}) mm\"", x[0], x[1]);
}

}  // namespace parison::tests
