// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "core/io/files.hpp"
#include "forming/report/solid/solid_files.hpp"

namespace parison::forming {
namespace {

using core::Point;
using Space = std::array<double, 3>;

constexpr double millimetre = 1e-3;

/// Triangles as a binary STL file has them, and the volume they enclose, in the unit of the corners.
class Triangles {
 public:
  void add(const Space& a, const Space& b, const Space& c) {
    const Space u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const Space normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double size = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (size == 0) return;
    for (const double component : normal) add_float(component / size);
    for (const Space* corner : {&a, &b, &c})
      for (const double component : *corner) add_float(component);
    bytes_.append(2, '\0');
    ++count_;
    volume_ += (a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2]) / 6;
  }
  double volume() const { return volume_; }
  std::string file() const {
    std::string head = "Parison: container of glass, mm";
    head.resize(80, ' ');
    std::string number(sizeof count_, '\0');
    std::memcpy(number.data(), &count_, sizeof count_);
    return head + number + bytes_;
  }

 private:
  void add_float(double value) {
    const auto single = static_cast<float>(value);
    char bytes[sizeof single];
    std::memcpy(bytes, &single, sizeof single);
    bytes_.append(bytes, sizeof single);
  }

  std::uint32_t count_ = 0;
  std::string bytes_;
  double volume_ = 0;
};

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
    return Space{x[0] * std::cos(angle) / millimetre, x[0] * std::sin(angle) / millimetre, x[1] / millimetre};
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
  return millimetre * millimetre * millimetre * triangles.volume();
}

}  // namespace parison::forming
