// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/triangles.hpp"

#include <Eigen/Geometry>
#include <cstring>

namespace parison::forming {

namespace {

void add_floats(const core::Vector3& values, std::string& bytes) {
  for (const double value : values) {
    const auto single = static_cast<float>(value);
    char own[sizeof single];
    std::memcpy(own, &single, sizeof single);
    bytes.append(own, sizeof single);
  }
}

}  // namespace

void Triangles::add(const core::Vector3& a, const core::Vector3& b, const core::Vector3& c) {
  const core::Vector3 normal = (b - a).cross(c - a);
  const double size = normal.norm();
  if (size == 0) return;
  add_floats(normal / size, bytes_);
  for (const core::Vector3* corner : {&a, &b, &c}) add_floats(*corner, bytes_);
  bytes_.append(2, '\0');
  ++count_;
  volume_ += a.dot(normal) / 6;
}

std::string Triangles::file() const {
  std::string head = "Parison: container of glass, mm";
  head.resize(80, ' ');
  std::string number(sizeof count_, '\0');
  std::memcpy(number.data(), &count_, sizeof count_);
  return head + number + bytes_;
}

}  // namespace parison::forming
