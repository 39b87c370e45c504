#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::core {

/// Point and weight of a rule on the reference triangle (area 1/2) or the reference edge [0, 1].
struct TriangleRulePoint {
  double a, b, weight;
};
struct EdgeRulePoint {
  double s, weight;
};

/// The six nodes of a quadratic triangle as points of the reference triangle, without weights.
inline constexpr std::array<TriangleRulePoint, 6> triangle_nodes{
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}, {0, 0.5, 0}}};

/// Symmetric rule on the reference triangle (Strang & Fix 1973, Radon 1948, Dunavant 1985), exact for polynomials up to
/// `degree` (at most 6).
const std::vector<TriangleRulePoint>& triangle_rule(int degree);
/// Gauss-Legendre rule on [0, 1] with `points` points (1 to 5), exact to degree 2 points - 1.
const std::vector<EdgeRulePoint>& edge_rule(int points);

/// Quadratic shape functions of the triangle at barycentric (1-a-b, a, b), in the order of Mesh::cells.
std::array<double, 6> triangle_shape(double a, double b);
/// Their derivatives with respect to a and b, [node][direction].
std::array<std::array<double, 2>, 6> triangle_shape_derivative(double a, double b);
/// Quadratic shape functions of an edge at s in [0, 1]: first, last, mid.
std::array<double, 3> edge_shape(double s);
/// Their derivatives with respect to s.
std::array<double, 3> edge_shape_derivative(double s);

/// A mapped quadrature point inside a cell.
struct CellPoint {
  std::array<double, 6> shape;
  std::array<Point, 6> gradient;  ///< 1/m
  std::array<double, 3> linear;   ///< barycentric coordinates: the linear shape functions
  Point position;                 ///< m
  double volume;                  ///< quadrature weight times the measure, m3; not positive where the cell is inverted
};
/// A mapped quadrature point on an edge.
struct EdgePoint {
  std::array<double, 3> shape;
  Point position;  ///< m
  Point normal;    ///< outward unit normal of the body on the edge's left; zero, as the tangent, where the edge has no
                   ///< extent
  Point tangent;   ///< unit, from first to last
  double area;     ///< quadrature weight times the measure, m2
};

/// Circumference 2 pi r of the ring through x, or 1 m.
double depth(Geometry geometry, const Point& x);
/// 1/r at x for axisymmetric scenes (the hoop strain rate is v_r / r), 0 for planar ones.
double hoop(Geometry geometry, const Point& x);

/// Maps a point of the reference triangle into a cell.
CellPoint map_cell_point(const Mesh& mesh, Index cell, Geometry geometry, const TriangleRulePoint& at);
/// Maps a point of the reference edge onto an edge, given by its nodes first, last, mid-side.
EdgePoint map_edge_point(const Mesh& mesh, const std::array<Index, 3>& edge, Geometry geometry,
                         const EdgeRulePoint& at);

}  // namespace parison::core
