// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/solid_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/math/numbers.hpp"
#include "core/process/child_work.hpp"
#include "core/process/gmsh_module.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/solid/step_solid.hpp"
#include "forming/report/solid/triangles.hpp"

namespace parison::forming {

namespace {

constexpr double cubic_millimetre = 1e-9;

/// The CAD kernel works in a process of its own; the number that it gives, m3.
double volume_from_kernel(const std::string& path, const std::function<void(std::string&)>& work) {
  core::ChildWork done;
  const auto text = [&] {
    std::string volume;
    work(volume);
    return volume;
  };
  core::in_gmsh_session([&] { done = core::in_child(text, {120, 2'000'000'000}); });
  if (!done.death.empty()) throw core::RunError(fmt::format("{}: the CAD kernel failed: {}", path, done.death));
  return cubic_millimetre * std::strtod(done.text.c_str(), nullptr);
}

}  // namespace

double write_step(const std::string& path, const ContainerShape& shape) {
  static auto& write = core::gmsh_function<decltype(parison_write_solid)>("parison_write_solid");
  const double volume =
      volume_from_kernel(path, [&](std::string& text) { write(core::unfinished_name(path), shape, text); });
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

/// The middle at an odd number of places: ends of elements at even indices, their middles between them. Elements are
/// about `size` long, m, but never across a bend of the points by more than they resolve.
std::vector<MidPoint> meridian(const std::vector<MidPoint>& middle, double size) {
  std::vector<double> arc{0};
  for (std::size_t i = 1; i < middle.size(); ++i) arc.push_back(arc.back() + distance(middle[i - 1], middle[i]));
  const int halves = 2 * std::max(1, static_cast<int>(std::ceil(arc.back() / size)));
  std::vector<MidPoint> found;
  std::size_t after = 1;
  for (int i = 0; i <= halves; ++i) {
    const double s = arc.back() * i / halves;
    while (after + 1 < arc.size() && arc[after] < s) ++after;
    const double t = (s - arc[after - 1]) / (arc[after] - arc[after - 1]);
    const MidPoint &a = middle[after - 1], &b = middle[after];
    found.push_back({(1 - t) * a.position + t * b.position, (1 - t) * a.thickness + t * b.thickness});
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
  long count() const { return next_ - 1; }

 private:
  int around_;
  long next_ = 1;
  std::vector<long> first_;
  std::vector<bool> on_axis_;
};

std::string node_lines(const std::vector<MidPoint>& points, int around, std::string& thickness) {
  std::string text;
  long number = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = points[i].position[0] / core::millimetre, z = points[i].position[1] / core::millimetre;
    for (int angle = 0; angle < (r == 0 ? 1 : around); angle += i % 2 == 0 ? 1 : 2) {
      const double turned = 2 * M_PI * angle / around;
      text += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", ++number, r * std::cos(turned), r * std::sin(turned), z);
      thickness += fmt::format("{}, {:.7g}\n", number, points[i].thickness / core::millimetre);
    }
  }
  return text;
}

/// Eight-node shells, and six-node ones where an end is on the axis.
void add_elements(const ShellNodes& nodes, std::size_t places, int around, std::string& eight, std::string& six,
                  long& count) {
  for (std::size_t i = 0; i + 2 < places; i += 2)
    for (int a = 0; a < around; a += 2) {
      const auto n = [&](std::size_t place, int angle) { return nodes.number(place, angle); };
      ++count;
      if (nodes.on_axis(i))
        six += fmt::format("{}, {}, {}, {}, {}, {}, {}\n", count, n(i, a), n(i + 2, a + 2), n(i + 2, a),
                           n(i + 1, a + 2), n(i + 2, a + 1), n(i + 1, a));
      else if (nodes.on_axis(i + 2))
        six += fmt::format("{}, {}, {}, {}, {}, {}, {}\n", count, n(i, a), n(i, a + 2), n(i + 2, a), n(i, a + 1),
                           n(i + 1, a + 2), n(i + 1, a));
      else
        eight += fmt::format("{}, {}, {}, {}, {}, {}, {}, {}, {}\n", count, n(i, a), n(i, a + 2), n(i + 2, a + 2),
                             n(i + 2, a), n(i, a + 1), n(i + 1, a + 2), n(i + 2, a + 1), n(i + 1, a));
    }
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

}  // namespace

std::string shell_text(const std::string& remark, const ShellLines& lines) {
  std::string text =
      "** Container by Parison: the middle of the wall. Units: mm, t, s, N, MPa. A positive pressure on WALL acts from "
      "inside.\n" +
      remark;
  text += "*NODE, NSET=CONTAINER\n" + lines.nodes;
  if (!lines.eight.empty()) text += "*ELEMENT, TYPE=S8, ELSET=WALL\n" + lines.eight;
  if (!lines.six.empty()) text += "*ELEMENT, TYPE=S6, ELSET=WALL\n" + lines.six;
  text += "*NODAL THICKNESS\n" + lines.thickness;
  return text +
         "** Soda-lime glass at room temperature: Young's modulus, Poisson's ratio, density.\n"
         "*MATERIAL, NAME=GLASS\n*ELASTIC\n70000., 0.22\n*DENSITY\n2.5e-9\n"
         "*SHELL SECTION, ELSET=WALL, MATERIAL=GLASS, NODAL THICKNESS\n1.\n";
}

ShellMesh write_shell(const std::string& path, const ContainerShape& shape, int divisions) {
  if (shape.middle.size() < 3) throw core::CaseError(fmt::format("{}: the glass is no wall, it has no middle", path));
  double radius = 0;
  for (const MidPoint& point : shape.middle) radius = std::max(radius, point.position[0]);
  std::vector<MidPoint> points = meridian(shape.middle, 2 * M_PI * radius / divisions);
  constexpr double near_axis = 0.02;  // of the radius: the middle ends on the axis there
  for (MidPoint* end : {&points.front(), &points.back()})
    if (end->position[0] < near_axis * radius) end->position[0] = 0;
  const int around = 2 * divisions;
  const ShellNodes nodes(points, around);
  std::string thickness, eight, six;
  const std::string coordinates = node_lines(points, around, thickness);
  long count = 0;
  add_elements(nodes, points.size(), around, eight, six, count);
  const std::string remark =
      fmt::format("** {:.1f} % of its length joins stretches of wall across feet and beads.\n", 100 * shape.bridged);
  core::replace_file(path, shell_text(remark, {coordinates, thickness, eight, six}));
  return {count, nodes.count(), shell_volume(points)};
}

}  // namespace parison::forming
