// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/solid_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/math/numbers.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/solid/kernel_work.hpp"
#include "forming/report/solid/step_solid.hpp"
#include "forming/report/solid/triangles.hpp"

namespace parison::forming {

double write_step(const std::string& path, const ContainerShape& shape) {
  static auto& write = core::gmsh_function<decltype(parison_write_solid)>("parison_write_solid");
  const std::string told =
      told_by_kernel(path, [&](std::string& text) { write(core::unfinished_name(path), shape, text); });
  const double volume = cubic_millimetre * std::strtod(told.c_str(), nullptr);
  if (!(volume > 0)) throw core::RunError(fmt::format("{}: the CAD kernel made no solid of the outline", path));
  core::take_made(path);
  return volume;
}

namespace {

using core::Point;
/// Sides around so that the middle of a side is within `deviation` of the circle of the widest place; of a small glass
/// so many that they enclose 0.05 % less than the circle at the most.
int sides_around(const std::vector<Point>& points, double deviation) {
  constexpr int least = 120;
  double radius = 0;
  for (const Point& x : points) radius = std::max(radius, x[0]);
  return std::clamp(static_cast<int>(std::ceil(M_PI / std::acos(1 - deviation / radius))), least, 1440);
}

}  // namespace

double write_stl(const std::string& path, const ContainerShape& shape, double deviation) {
  const auto& points = shape.outline;
  const int sides = sides_around(points, deviation);
  const auto at = [&](const Point& x, int side) {
    const double angle = 2 * M_PI * (side % sides) / sides;
    return core::Vector3{x[0] * std::cos(angle) / core::millimetre, x[0] * std::sin(angle) / core::millimetre,
                         x[1] / core::millimetre};
  };
  Triangles triangles;
  for (std::size_t i = 0; i + (shape.is_loop ? 0 : 1) < points.size(); ++i) {
    const Point &a = points[i], &b = points[(i + 1) % points.size()];
    for (int side = 0; side < sides; ++side) {
      if (a[0] > 0) triangles.add(at(a, side), at(a, side + 1), at(b, side));
      if (b[0] > 0) triangles.add(at(a, side + 1), at(b, side + 1), at(b, side));
    }
  }
  core::replace_file(path, triangles.file());
  return core::millimetre * core::millimetre * core::millimetre * triangles.volume();
}

namespace {

double distance(const MidPoint& a, const MidPoint& b) {
  return (a.position - b.position).norm();
}

/// The place on which the wall stands: its lowest one, the widest where several are within 0.02 mm of that.
std::size_t standing_place(const std::vector<MidPoint>& middle, int up) {
  constexpr double flat = 2e-5;  // m
  const auto height = [&](const MidPoint& point) { return up * point.outer; };
  const double lowest = height(*std::min_element(
      middle.begin(), middle.end(), [&](const MidPoint& a, const MidPoint& b) { return height(a) < height(b); }));
  std::size_t found = middle.size();
  for (std::size_t i = 0; i < middle.size(); ++i)
    if (height(middle[i]) <= lowest + flat &&
        (found == middle.size() || middle[i].position[0] > middle[found].position[0]))
      found = i;
  return found;
}

MidPoint between(const MidPoint& a, const MidPoint& b, double t) {
  return {(1 - t) * a.position + t * b.position, (1 - t) * a.thickness + t * b.thickness,
          (1 - t) * a.outer + t * b.outer};
}

/// A line of points by its arc length, m.
class MiddleLine {
 public:
  explicit MiddleLine(const std::vector<MidPoint>& points) : points_(points), arc_{0} {
    for (std::size_t i = 1; i < points.size(); ++i) arc_.push_back(arc_.back() + distance(points[i - 1], points[i]));
  }
  double length() const { return arc_.back(); }
  double arc(std::size_t point) const { return arc_[point]; }
  /// The place of a parabola through as much of the line as the wall is thick (A. Savitzky, M. J. E. Golay, Anal. Chem.
  /// 36 (1964) 1627-1639, nine points): what is shorter is nothing that a shell could bear.
  MidPoint smooth_at(double s) const {
    constexpr int reach = 4;
    const double half = std::min({0.5 * at(s).thickness, s, length() - s});
    MidPoint sum{Point::Zero(), 0, at(s).outer};
    for (int i = -reach; i <= reach; ++i) {
      const MidPoint point = at(s + half * i / reach);
      const double weight = (59 - 5 * i * i) / 231.0;
      sum.position += weight * point.position;
      sum.thickness += weight * point.thickness;
    }
    return sum;
  }

 private:
  MidPoint at(double s) const {
    const auto after = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::lower_bound(arc_.begin(), arc_.end(), s) - arc_.begin()), 1, arc_.size() - 1);
    return between(points_[after - 1], points_[after], (s - arc_[after - 1]) / (arc_[after] - arc_[after - 1]));
  }

  const std::vector<MidPoint>& points_;
  std::vector<double> arc_;
};

/// The middle at an odd number of places: ends of elements at even indices, their middles between them. Elements are at
/// most `size` long, m; one ends at the place on which the wall stands.
std::vector<MidPoint> meridian(const std::vector<MidPoint>& middle, double size, int up) {
  const MiddleLine line(middle);
  std::vector<double> ends{line.length()};
  const double standing = line.arc(standing_place(middle, up));
  if (standing > 0.5 * size && line.length() - standing > 0.5 * size) ends.insert(ends.begin(), standing);
  std::vector<MidPoint> found{middle.front()};
  double start = 0;
  for (const double end : ends) {
    const int halves = 2 * static_cast<int>(std::ceil((end - start) / size));
    for (int i = 1; i <= halves; ++i) found.push_back(line.smooth_at(start + (end - start) * i / halves));
    start = end;
  }
  return found;
}

/// Numbers the nodes of a meridian turned about the axis: even places have nodes at all `around` angles, odd ones at
/// every second; a place on the axis has one node.
class ShellNodes {
 public:
  ShellNodes(const std::vector<MidPoint>& points, int around) : around_(around) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      first_.push_back(next_);
      on_axis_.push_back(points[i].position[0] == 0);
      next_ += on_axis_[i] ? 1 : i % 2 == 0 ? around : around / 2;
    }
  }
  long number(std::size_t place, int angle) const {
    if (on_axis_[place]) return first_[place];
    const int turned = angle % around_;
    return first_[place] + (place % 2 == 0 ? turned : turned / 2);
  }
  bool on_axis(std::size_t place) const { return on_axis_[place]; }

 private:
  int around_;
  long next_ = 1;
  std::vector<long> first_;
  std::vector<bool> on_axis_;
};

/// The meridian turned about the axis: shells of eight nodes, and of six where an end is on the axis.
Shell turned(const std::vector<MidPoint>& points, int around) {
  const ShellNodes nodes(points, around);
  Shell shell;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = points[i].position[0] / core::millimetre, z = points[i].position[1] / core::millimetre;
    for (int angle = 0; angle < (r == 0 ? 1 : around); angle += i % 2 == 0 ? 1 : 2) {
      const double turn = 2 * M_PI * angle / around;
      shell.nodes.push_back({{r * std::cos(turn), r * std::sin(turn), z},
                             points[i].thickness / core::millimetre,
                             points[i].outer / core::millimetre});
    }
  }
  for (std::size_t i = 0; i + 2 < points.size(); i += 2)
    for (int a = 0; a < around; a += 2) {
      const auto n = [&](std::size_t place, int angle) { return nodes.number(place, angle); };
      if (nodes.on_axis(i))
        shell.elements.push_back(
            {n(i, a), n(i + 2, a + 2), n(i + 2, a), n(i + 1, a + 2), n(i + 2, a + 1), n(i + 1, a)});
      else if (nodes.on_axis(i + 2))
        shell.elements.push_back({n(i, a), n(i, a + 2), n(i + 2, a), n(i, a + 1), n(i + 1, a + 2), n(i + 1, a)});
      else
        shell.elements.push_back({n(i, a), n(i, a + 2), n(i + 2, a + 2), n(i + 2, a), n(i, a + 1), n(i + 1, a + 2),
                                  n(i + 2, a + 1), n(i + 1, a)});
    }
  return shell;
}

/// Middle surface times thickness, by cones, m3.
double shell_volume(const std::vector<MidPoint>& points) {
  double volume = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const MidPoint &a = points[i - 1], &b = points[i];
    const double ra = a.position[0], rb = b.position[0], ta = a.thickness, tb = b.thickness;
    volume += 2 * M_PI * distance(a, b) * (ra * ta / 3 + rb * tb / 3 + (ra * tb + rb * ta) / 6);
  }
  return volume;
}

/// Divisions around with which S8, which is too stiff in bending where it is large, squeezes as S8R does, within 2 %:
/// the square of their length is at most half of radius times thickness.
int bending_divisions(double radius, double thickness) {
  constexpr double share = 0.5;
  constexpr int quarters = 4;  // both planes of the axes have nodes
  return quarters * static_cast<int>(std::ceil(2 * M_PI * std::sqrt(radius / (share * thickness)) / quarters));
}

}  // namespace

ShellMesh write_shell(const std::string& path, const ContainerShape& shape, ShellGlass glass, int divisions) {
  if (shape.middle.size() < 3) throw core::CaseError(fmt::format("{}: the glass is no wall, it has no middle", path));
  double radius = 0, thickness = 0;
  for (const MidPoint& point : shape.middle) {
    radius = std::max(radius, point.position[0]);
    thickness += point.thickness / static_cast<double>(shape.middle.size());
  }
  if (glass.residual) divisions = std::max(divisions, bending_divisions(radius, thickness));
  std::vector<MidPoint> points = meridian(shape.middle, M_PI * radius / divisions, glass.up);
  constexpr double near_axis = 0.02;  // of the radius: the middle ends on the axis there
  for (MidPoint* end : {&points.front(), &points.back()})
    if (end->position[0] < near_axis * radius) end->position[0] = 0;
  const Shell shell = turned(points, 2 * divisions);
  glass.remark +=
      fmt::format("** {:.1f} % of the wall's length joins stretches across feet and beads.\n", 100 * shape.bridged);
  core::replace_file(path, shell_text(shell, glass));
  return {static_cast<long>(shell.elements.size()), static_cast<long>(shell.nodes.size()), shell_volume(points)};
}

}  // namespace parison::forming
