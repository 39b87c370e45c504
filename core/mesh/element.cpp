// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/element.hpp"

#include <cassert>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/mesh/cell_batch.hpp"

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
  CellShapes<6, 1> shapes;
  set_shapes(at.a, at.b, 0, shapes);
  const auto& nodes = mesh.cells()[cell];
  std::array<std::array<double, 6>, dim> x;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a) x[a][i] = mesh.nodes[nodes[i]][a];
  MappedPoint<double> mapped;
  map_point(shapes, 0, x, mapped);
  CellPoint point;
  for (int i = 0; i < 6; ++i) point.shape[i] = shapes.value(0, i);
  point.linear = {1 - at.a - at.b, at.a, at.b};
  point.position = {mapped.position[0], mapped.position[1]};
  set_gradients(shapes, 0, mapped, point.gradient);
  point.volume = at.weight * mapped.determinant * depth(geometry, point.position);
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

}  // namespace parison::core
