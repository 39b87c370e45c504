#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::contact::testing {

using core::Point;

struct Outline {
  core::Profile profile;
  std::vector<bool> contact;
};

/// Draws an outline with the tool on the left; boundary 0 is free, boundary 1 in contact.
class Pen {
 public:
  explicit Pen(const Point& start) : at_(start), start_(start) {
    outline_ = {{{}, {"free", "contact"}}, {false, true}};
  }
  Pen& free(const Point& to) { return line(to, 0); }
  Pen& contact(const Point& to) { return line(to, 1); }
  Pen& contact_arc(const Point& centre, double radius, double from, double to) {
    core::Segment arc;
    arc.start = at_;
    arc.end = centre + radius * Point(std::cos(to), std::sin(to));
    arc.is_arc = true;
    arc.centre = centre;
    arc.radius = radius;
    arc.from = from;
    arc.to = to;
    arc.boundary_id = 1;
    outline_.profile.segments.push_back(arc);
    at_ = arc.end;
    return *this;
  }
  Outline close() {
    line(start_, 0);
    return outline_;
  }

 private:
  Pen& line(const Point& to, core::Index boundary) {
    core::Segment segment;
    segment.start = at_;
    segment.end = to;
    segment.boundary_id = boundary;
    outline_.profile.segments.push_back(segment);
    at_ = to;
    return *this;
  }
  Point at_, start_;
  Outline outline_;
};

inline Point mm(double r, double z) {
  return {1e-3 * r, 1e-3 * z};
}

/// The tools of the reference jar.
inline Outline blank() {
  return Pen(mm(0, 98))
      .contact(mm(13.5, 98))
      .contact_arc(mm(13.5, 84), 14e-3, M_PI / 2, 0)
      .contact(mm(29.5, 20))
      .contact(mm(31, 14))
      .free(mm(56, 14))
      .free(mm(56, 123))
      .free(mm(0, 123))
      .close();
}

inline Outline plunger(double tip) {
  return Pen(mm(12, tip - 140))
      .free(mm(27, tip - 140))
      .contact(mm(27, tip - 78))
      .contact(mm(24.5, tip - 72))
      .contact(mm(21.5, tip - 12))
      .contact_arc(mm(9.5, tip - 12), 12e-3, 0, M_PI / 2)
      .contact(mm(0, tip))
      .free(mm(0, tip - 25))
      .free(mm(12, tip - 25))
      .close();
}

inline Outline blow_mould() {
  return Pen(mm(0, 126))
      .contact(mm(12, 129))
      .contact(mm(30, 129))
      .contact_arc(mm(30, 122), 7e-3, M_PI / 2, 0)
      .contact(mm(37, 26))
      .contact(mm(31, 14))
      .free(mm(62, 14))
      .free(mm(62, 154))
      .free(mm(0, 154))
      .close();
}

inline Outline neck_ring() {
  return Pen(mm(31, 14)).contact(mm(31, 0)).free(mm(56, 0)).free(mm(56, 14)).close();
}

inline Outline guide_plate() {
  return Pen(mm(0, -20)).free(mm(31, -20)).free(mm(31, 0)).contact(mm(0, 0)).close();
}

}  // namespace parison::contact::testing
