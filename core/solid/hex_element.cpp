// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/hex_element.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

namespace parison::core {

std::vector<LineRulePoint> gauss_rule(int points) {
  std::vector<LineRulePoint> rule(points);
  for (int i = 0; i < points; ++i) {
    double x = std::cos(M_PI * (i + 0.75) / (points + 0.5)), slope = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {  // Newton's method on the polynomial of Legendre
      double last = 1, value = x;
      for (int k = 2; k <= points; ++k) last = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * last) / k);
      slope = points * (x * value - last) / (x * x - 1);
      x -= value / slope;
    }
    rule[points - 1 - i] = {0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)};
  }
  return rule;
}

std::array<double, 3> line_shape(double at) {
  return {(1 - at) * (1 - 2 * at), 4 * at * (1 - at), at * (2 * at - 1)};
}

std::array<double, 3> line_shape_derivative(double at) {
  return {4 * at - 3, 4 - 8 * at, 4 * at - 1};
}

HexShape hex_shape(const Vector3& at) {
  const auto x = line_shape(at[0]), y = line_shape(at[1]), z = line_shape(at[2]);
  HexShape shape;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) shape[i + 3 * j + 9 * k] = x[i] * y[j] * z[k];
  return shape;
}

HexGradient hex_shape_derivative(const Vector3& at) {
  const auto x = line_shape(at[0]), y = line_shape(at[1]), z = line_shape(at[2]);
  const auto dx = line_shape_derivative(at[0]), dy = line_shape_derivative(at[1]), dz = line_shape_derivative(at[2]);
  HexGradient derivative;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        derivative.col(i + 3 * j + 9 * k) << dx[i] * y[j] * z[k], x[i] * dy[j] * z[k], x[i] * y[j] * dz[k];
  return derivative;
}

namespace {

HexRule make_rule(int along, int across) {
  HexRule rule;
  for (const auto& z : gauss_rule(across))
    for (const auto& y : gauss_rule(along))
      for (const auto& x : gauss_rule(along)) {
        rule.at.push_back({x.at, y.at, z.at});
        rule.weight.push_back(x.weight * y.weight * z.weight);
        rule.derivative.push_back(hex_shape_derivative(rule.at.back()));
      }
  rule.shape.resize(27, static_cast<Index>(rule.at.size()));
  for (std::size_t q = 0; q < rule.at.size(); ++q) rule.shape.col(static_cast<Index>(q)) = hex_shape(rule.at[q]);
  return rule;
}

}  // namespace

const HexRule& hex_rule(int along, int across) {
  static std::map<std::pair<int, int>, HexRule> rules;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto [rule, is_new] = rules.try_emplace({along, across});
  if (is_new) rule->second = make_rule(along, across);
  return rule->second;
}

HexPoint map_hex_point(const HexNodes& nodes, const HexRule& rule, std::size_t point) {
  const Eigen::Matrix3d jacobian = nodes * rule.derivative[point].transpose();
  const double determinant = jacobian.determinant();
  return {jacobian.inverse().transpose() * rule.derivative[point], rule.weight[point] * determinant};
}

const std::array<int, 9>& hex_face_nodes(int axis, int end) {
  static const auto table = [] {
    constexpr std::array<int, 3> stride{1, 3, 9};
    std::array<std::array<std::array<int, 9>, 2>, 3> all{};
    for (int normal = 0; normal < 3; ++normal)
      for (int side = 0; side < 2; ++side)
        for (int b = 0; b < 3; ++b)
          for (int a = 0; a < 3; ++a)
            all[normal][side][a + 3 * b] =
                2 * side * stride[normal] + a * stride[normal == 0] + b * stride[normal == 2 ? 1 : 2];
    return all;
  }();
  return table[axis][end];
}

std::vector<HexFacePoint> map_hex_face(const HexFaceNodes& nodes, const HexFace& face, int points) {
  // The cross product of the face's coordinates is along the cell's axis, but against it for the middle one.
  const double outward = (face.end == 1) == (face.axis != 1) ? 1 : -1;
  const auto rule = gauss_rule(points);
  std::vector<HexFacePoint> mapped;
  mapped.reserve(rule.size() * rule.size());
  for (const auto& v : rule)
    for (const auto& u : rule) {
      const auto x = line_shape(u.at), y = line_shape(v.at);
      const auto dx = line_shape_derivative(u.at), dy = line_shape_derivative(v.at);
      HexFacePoint at;
      Eigen::Matrix<double, 2, 9> derivative;
      for (int b = 0; b < 3; ++b)
        for (int a = 0; a < 3; ++a) {
          at.shape[a + 3 * b] = x[a] * y[b];
          derivative.col(a + 3 * b) << dx[a] * y[b], x[a] * dy[b];
        }
      const Eigen::Matrix<double, 3, 2> tangents = nodes * derivative.transpose();
      const Vector3 cross = outward * tangents.col(0).cross(tangents.col(1));
      at.gradient = tangents * (tangents.transpose() * tangents).inverse() * derivative;
      at.position = nodes * at.shape;
      at.area = cross.norm() * u.weight * v.weight;
      at.normal = cross.normalized();
      mapped.push_back(at);
    }
  return mapped;
}

}  // namespace parison::core
