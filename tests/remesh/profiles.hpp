#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/mesh/profile.hpp"

namespace parison::remesh {

/// Draws an outline in mm, line by line and arc by arc.
class Pen {
 public:
  Pen(double r, double z) : at_(1e-3 * r, 1e-3 * z) {}

  Pen& line(double r, double z, const std::string& boundary) {
    core::Segment segment;
    segment.start = at_;
    segment.end = at_ = 1e-3 * core::Point(r, z);
    return add(segment, boundary);
  }

  Pen& arc(double r, double z, double from, double to, const std::string& boundary) {
    core::Segment segment;
    segment.start = at_;
    segment.is_arc = true;
    segment.centre = 1e-3 * core::Point(r, z);
    segment.from = from * M_PI / 180;
    segment.to = to * M_PI / 180;
    segment.radius = (at_ - segment.centre).norm();
    at_ = segment.end = segment.centre + segment.radius * core::Point(std::cos(segment.to), std::sin(segment.to));
    if (std::abs(at_[0]) < 1e-15) segment.end[0] = at_[0] = 0;
    return add(segment, boundary);
  }

  /// The closed outline with the body on its left.
  core::Profile closed() const { return core::signed_area(profile_) > 0 ? profile_ : core::reversed(profile_); }

 private:
  Pen& add(core::Segment segment, const std::string& boundary) {
    auto& names = profile_.boundary_names;
    std::size_t i = 0;
    while (i < names.size() && names[i] != boundary) ++i;
    if (i == names.size()) names.push_back(boundary);
    segment.boundary_id = static_cast<core::Index>(i);
    profile_.segments.push_back(segment);
    return *this;
  }

  core::Point at_;
  core::Profile profile_;
};

/// Gob of the reference jar: radius 26, hemispherical ends, lower pole at z = 20.
inline core::Profile gob(double straight = 8.4) {
  return Pen(0, 20)
      .arc(0, 46, -90, 0, "surface")
      .line(26, 46 + straight, "surface")
      .arc(0, 46 + straight, 0, 90, "surface")
      .line(0, 20, "axis")
      .closed();
}

inline core::Profile blank() {
  return Pen(31, 14)
      .line(29.5, 20, "cavity")
      .line(27.5, 84, "cavity")
      .arc(13.5, 84, 0, 90, "cavity")
      .line(0, 98, "cavity")
      .line(0, 123, "axis")
      .line(52.5, 123, "outside")
      .line(56, 14, "outside")
      .line(31, 14, "joint")
      .closed();
}

inline core::Profile plunger(double tip = 20) {
  return Pen(27, tip - 140)
      .line(27, tip - 78, "outer")
      .line(24.5, tip - 72, "outer")
      .line(21.5, tip - 12, "outer")
      .arc(9.5, tip - 12, 0, 90, "outer")
      .line(0, tip, "outer")
      .line(0, tip - 12, "axis")
      .line(12, tip - 12, "bore")
      .line(12, tip - 140, "bore")
      .line(27, tip - 140, "foot")
      .closed();
}

inline core::Profile blow_mould() {
  return Pen(31, 14)
      .line(37, 26, "cavity")
      .line(37, 122, "cavity")
      .arc(30, 122, 0, 90, "cavity")
      .line(12, 129, "cavity")
      .line(0, 126, "cavity")
      .line(0, 154, "axis")
      .line(62, 154, "outside")
      .line(62, 14, "outside")
      .line(31, 14, "joint")
      .closed();
}

inline core::Profile neck_ring() {
  return Pen(31, 0).line(31, 14, "cavity").line(56, 14, "joint").line(56, 0, "outside").line(31, 0, "joint").closed();
}

/// Cup open at the bottom with a wall of the given thickness (mm): inner radius 25, 60 high, domed.
inline core::Profile cup(double wall) {
  return Pen(25, 0)
      .line(25 + wall, 0, "rim")
      .line(25 + wall, 60, "outer")
      .arc(0, 60, 0, 90, "outer")
      .line(0, 85, "axis")
      .arc(0, 60, 90, 0, "inner")
      .line(25, 0, "inner")
      .closed();
}

}  // namespace parison::remesh
