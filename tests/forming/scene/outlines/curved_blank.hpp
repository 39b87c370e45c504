#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// A blank with a curved inner side, and how far segments are off a curve.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../../scene_text.hpp"
#include "core/io/files.hpp"

namespace parison::forming {

using core::Point;
using core::Segment;

/// The largest angle between the tangents where two segments meet, rad.
inline double largest_kink(const std::vector<Segment>& segments) {
  double kink = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    EXPECT_LT((segments[i].start - segments[i - 1].end).norm(), 1e-12);
    const Point a = core::tangent_at(segments[i - 1], 1), b = core::tangent_at(segments[i], 0);
    kink = std::max(kink, std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b))));
  }
  return kink;
}

/// The largest distance of a curve from the segments, m.
inline double off(const std::vector<Segment>& segments, const std::function<Point(double)>& curve) {
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    double distance = 1;
    for (const Segment& segment : segments) distance = core::distance(segment, curve(i / 1000.0), distance);
    worst = std::max(worst, distance);
  }
  return worst;
}

/// The small scene and a blank whose inner side from (30, 14) to (0, 98) mm is `keys`.
inline std::string with_blank(const std::string& keys) {
  return replaced("[[interface]]\n",
                  "[[tool]]\nname = \"blank\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\n"
                  "position = \"200 mm\"\nboundary = [\n{ name = \"inner\", condition = \"contact\", " +
                      keys +
                      " },\n{ name = \"axis\", condition = \"symmetry\", path = \"(0, 123) mm\" },\n"
                      "{ name = \"outer\", condition = \"insulated\", path = \"(56, 123) (56, 14) (30, 14) mm\" } ]\n"
                      "[[interface]]\n");
}

inline core::Profile blank_of(const std::string& keys, const std::string& file, const std::string& text) {
  const std::string folder = write_scene(with_blank(keys));
  core::write_text(folder + "/" + file, text);
  return read_scene(folder, "draft").tools.back().profile;
}

/// The quarter of an ellipse from (30, 14) to (0, 98) mm, about (0, 14) mm.
inline Point quarter(double s) {
  return {0.03 * std::cos(M_PI / 2 * s), 0.014 + 0.084 * std::sin(M_PI / 2 * s)};
}

inline std::vector<Segment> inner_of(const core::Profile& blank) {
  std::vector<Segment> inner;
  for (const Segment& segment : core::signed_area(blank) > 0 ? blank.segments : core::reversed(blank).segments)
    if (segment.boundary_id == 0) inner.push_back(segment);
  return inner;
}

}  // namespace parison::forming
