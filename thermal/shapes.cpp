// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/shapes.hpp"

namespace parison::thermal {

template <>
const CellShapes<6>& cell_shapes<6>() {
  static const CellShapes<6> shapes = [] {
    CellShapes<6> made;
    const auto& rule = core::triangle_rule(4);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const auto value = core::triangle_shape(rule[q].a, rule[q].b);
      const auto slope = core::triangle_shape_derivative(rule[q].a, rule[q].b);
      for (int i = 0; i < 6; ++i) {
        made.value(q, i) = value[i];
        made.slope_a(q, i) = slope[i][0];
        made.slope_b(q, i) = slope[i][1];
      }
    }
    return made;
  }();
  return shapes;
}

template <>
const CellShapes<3>& cell_shapes<3>() {
  static const CellShapes<3> shapes = [] {
    CellShapes<3> made;
    const auto& rule = core::triangle_rule(4);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      made.value.row(q) << 1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b;
      made.slope_a.row(q) << -1, 1, 0;
      made.slope_b.row(q) << -1, 0, 1;
    }
    return made;
  }();
  return shapes;
}

const EdgeShapes& edge_shapes() {
  static const EdgeShapes shapes = [] {
    EdgeShapes made;
    const auto& rule = core::edge_rule(3);
    for (std::size_t q = 0; q < made.size(); ++q) made[q] = core::edge_shape(rule[q].s);
    return made;
  }();
  return shapes;
}

}  // namespace parison::thermal
