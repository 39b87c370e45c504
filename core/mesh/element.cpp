// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/element.hpp"

#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

namespace parison::core {

namespace {

void add_orbit(std::vector<TriangleRulePoint>& rule, double weight, double a) {
  const double b = 1 - 2 * a;
  rule.push_back({a, a, weight});
  rule.push_back({b, a, weight});
  rule.push_back({a, b, weight});
}

void add_orbit(std::vector<TriangleRulePoint>& rule, double weight, double a, double b) {
  const double c = 1 - a - b;
  for (const auto& [p, q] : {std::pair{a, b}, {b, a}, {a, c}, {c, a}, {b, c}, {c, b}}) rule.push_back({p, q, weight});
}

/// Symmetric rules of Strang & Fix, Radon (1948) and Dunavant (1985), weights summing to 1/2.
std::vector<TriangleRulePoint> make_triangle_rule(int degree) {
  std::vector<TriangleRulePoint> rule;
  if (degree <= 2) {
    add_orbit(rule, 1.0 / 6, 1.0 / 6);
  } else if (degree <= 4) {
    add_orbit(rule, 0.5 * 0.223381589678011, 0.445948490915965);
    add_orbit(rule, 0.5 * 0.109951743655322, 0.091576213509771);
  } else if (degree == 5) {
    const double root = std::sqrt(15.0);
    rule.push_back({1.0 / 3, 1.0 / 3, 0.5 * 9 / 40});
    add_orbit(rule, 0.5 * (155 - root) / 1200, (6 - root) / 21);
    add_orbit(rule, 0.5 * (155 + root) / 1200, (6 + root) / 21);
  } else {
    add_orbit(rule, 0.5 * 0.116786275726379, 0.249286745170910);
    add_orbit(rule, 0.5 * 0.050844906370207, 0.063089014491502);
    add_orbit(rule, 0.5 * 0.082851075618374, 0.310352451033785, 0.053145049844816);
  }
  double sum = 0;
  for (const auto& p : rule) sum += p.weight;
  for (auto& p : rule) p.weight *= 0.5 / sum;  // the printed digits do not sum to 1/2 to round-off
  return rule;
}

}  // namespace

const std::vector<TriangleRulePoint>& triangle_rule(int degree) {
  static const std::vector<TriangleRulePoint> two = make_triangle_rule(2), four = make_triangle_rule(4),
                                              five = make_triangle_rule(5), six = make_triangle_rule(6);
  assert(degree <= 6);
  return degree <= 2 ? two : degree <= 4 ? four : degree == 5 ? five : six;
}

const std::vector<EdgeRulePoint>& edge_rule(int points) {
  static const std::array<std::vector<EdgeRulePoint>, 5> rules = [] {
    std::array<std::vector<EdgeRulePoint>, 5> made;
    for (int n = 1; n <= 5; ++n)
      for (int i = 0; i < n; ++i) {
        double x = -std::cos(M_PI * (i + 0.75) / (n + 0.5)), derivative = 1;
        for (int k = 0; k < 60; ++k) {
          double p0 = 1, p1 = x;
          for (int m = 2; m <= n; ++m) std::tie(p0, p1) = std::pair{p1, ((2 * m - 1) * x * p1 - (m - 1) * p0) / m};
          derivative = n * (x * p1 - p0) / (x * x - 1);
          const double step = p1 / derivative;
          x -= step;
          if (std::abs(step) < 1e-16) break;
        }
        made[n - 1].push_back({0.5 * (1 + x), 1 / ((1 - x * x) * derivative * derivative)});
      }
    return made;
  }();
  assert(points >= 1 && points <= 5);
  return rules[points - 1];
}

std::array<double, 6> triangle_shape(double a, double b) {
  const double c = 1 - a - b;
  return {c * (2 * c - 1), a * (2 * a - 1), b * (2 * b - 1), 4 * c * a, 4 * a * b, 4 * b * c};
}

std::array<std::array<double, 2>, 6> triangle_shape_derivative(double a, double b) {
  const double c = 1 - a - b;
  return {{{1 - 4 * c, 1 - 4 * c},
           {4 * a - 1, 0},
           {0, 4 * b - 1},
           {4 * (c - a), -4 * a},
           {4 * b, 4 * a},
           {-4 * b, 4 * (c - b)}}};
}

std::array<double, 3> edge_shape(double s) {
  return {(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)};
}

std::array<double, 3> edge_shape_derivative(double s) {
  return {4 * s - 3, 4 * s - 1, 4 - 8 * s};
}

double depth(Geometry geometry, const Point& x) {
  return geometry == Geometry::axisymmetric ? 2 * M_PI * x[0] : 1.0;
}

double hoop(Geometry geometry, const Point& x) {
  return geometry == Geometry::axisymmetric ? 1 / x[0] : 0.0;
}

CellPoint map_cell_point(const Mesh& mesh, Index cell, Geometry geometry, const TriangleRulePoint& at) {
  const auto& nodes = mesh.cells()[cell];
  const auto derivative = triangle_shape_derivative(at.a, at.b);
  CellPoint point;
  point.shape = triangle_shape(at.a, at.b);
  point.linear = {1 - at.a - at.b, at.a, at.b};
  point.position = Point::Zero();
  Tensor jacobian = Tensor::Zero();
  for (int i = 0; i < 6; ++i) {
    const Point& x = mesh.nodes[nodes[i]];
    point.position += point.shape[i] * x;
    jacobian.col(0) += derivative[i][0] * x;
    jacobian.col(1) += derivative[i][1] * x;
  }
  const double determinant = jacobian(0, 0) * jacobian(1, 1) - jacobian(0, 1) * jacobian(1, 0);
  const double s = 1 / determinant;
  for (int i = 0; i < 6; ++i)
    point.gradient[i] = {s * (jacobian(1, 1) * derivative[i][0] - jacobian(1, 0) * derivative[i][1]),
                         s * (-jacobian(0, 1) * derivative[i][0] + jacobian(0, 0) * derivative[i][1])};
  point.volume = at.weight * determinant * depth(geometry, point.position);
  return point;
}

EdgePoint map_edge_point(const Mesh& mesh, const std::array<Index, 3>& edge, Geometry geometry,
                         const EdgeRulePoint& at) {
  const auto derivative = edge_shape_derivative(at.s);
  EdgePoint point;
  point.shape = edge_shape(at.s);
  point.position = Point::Zero();
  Point along = Point::Zero();
  for (int i = 0; i < 3; ++i) {
    point.position += point.shape[i] * mesh.nodes[edge[i]];
    along += derivative[i] * mesh.nodes[edge[i]];
  }
  const double jacobian = along.norm();
  point.tangent = jacobian > 0 ? Point(along / jacobian) : Point::Zero();
  point.normal = {point.tangent[1], -point.tangent[0]};
  point.area = at.weight * jacobian * depth(geometry, point.position);
  return point;
}

CellMap cell_map(const Mesh& mesh, Index cell) {
  const auto& n = mesh.cells()[cell];
  const auto at = [&](int k) -> const Point& { return mesh.nodes[n[k]]; };
  return {at(0),
          at(1) - at(0),
          at(2) - at(0),
          {at(3) - 0.5 * (at(0) + at(1)), at(4) - 0.5 * (at(1) + at(2)), at(5) - 0.5 * (at(2) + at(0))}};
}

namespace {

/// A change of the reference coordinates that Newton's next step squares.
constexpr double tolerance = 1e-7;

}  // namespace

std::array<BatchArray, 2> invert(const CellMap& map, const BatchArray& x, const BatchArray& y) {
  const auto& [m, n, p] = map.mid_side_offset;
  const Point &u = map.u, &v = map.v;
  const double area = u[0] * v[1] - u[1] * v[0];
  const BatchArray target_x = x - map.origin[0], target_y = y - map.origin[1];
  BatchArray a = (target_x * v[1] - target_y * v[0]) / area, b = (u[0] * target_y - u[1] * target_x) / area;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const BatchArray c = 1 - a - b, ca = 4 * c * a, ab = 4 * a * b, bc = 4 * b * c;
    const BatchArray residual_x = target_x - a * u[0] - b * v[0] - ca * m[0] - ab * n[0] - bc * p[0];
    const BatchArray residual_y = target_y - a * u[1] - b * v[1] - ca * m[1] - ab * n[1] - bc * p[1];
    const BatchArray c_a = 4 * (c - a), c_b = 4 * (c - b), a4 = 4 * a, b4 = 4 * b;
    const BatchArray along_ax = u[0] + c_a * m[0] + b4 * (n[0] - p[0]),
                     along_ay = u[1] + c_a * m[1] + b4 * (n[1] - p[1]);
    const BatchArray along_bx = v[0] + c_b * p[0] + a4 * (n[0] - m[0]),
                     along_by = v[1] + c_b * p[1] + a4 * (n[1] - m[1]);
    const BatchArray scale = 1 / (along_ax * along_by - along_ay * along_bx);
    const BatchArray da = scale * (residual_x * along_by - residual_y * along_bx);
    const BatchArray db = scale * (along_ax * residual_y - along_ay * residual_x);
    a += da;
    b += db;
    const double change = (da.abs() + db.abs()).maxCoeff();
    if (change < tolerance || !((a.abs() + b.abs()).maxCoeff() < 1e3)) break;
  }
  return {a, b};
}

std::array<double, 2> invert(const CellMap& map, const Point& x) {
  const auto cross = [](const Point& p, const Point& q) { return p[0] * q[1] - p[1] * q[0]; };
  const auto& [m, n, p] = map.mid_side_offset;
  const Point target = x - map.origin;
  const double area = cross(map.u, map.v);
  double a = cross(target, map.v) / area, b = cross(map.u, target) / area;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const double c = 1 - a - b;
    const Point residual = target - a * map.u - b * map.v - 4 * (c * a * m + a * b * n + b * c * p);
    const Point along_a = map.u + 4 * ((c - a) * m + b * (n - p)), along_b = map.v + 4 * ((c - b) * p + a * (n - m));
    const double scale = 1 / cross(along_a, along_b);
    const double da = scale * cross(residual, along_b), db = scale * cross(along_a, residual);
    a += da;
    b += db;
    if (std::abs(da) + std::abs(db) < tolerance || !(std::abs(a) < 1e3 && std::abs(b) < 1e3)) break;
  }
  return {a, b};
}

std::array<double, 2> invert_cell_map(const Mesh& mesh, Index cell, const Point& x) {
  return invert(cell_map(mesh, cell), x);
}

}  // namespace parison::core
