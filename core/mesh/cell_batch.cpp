// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cell_batch.hpp"

#include "core/mesh/element.hpp"

namespace parison::core {

template <>
const CellShapes<6>& cell_shapes<6>() {
  static const CellShapes<6> shapes = [] {
    CellShapes<6> made;
    const auto& rule = triangle_rule(4);
    for (int q = 0; q < cell_points; ++q) set_shapes(rule[q].a, rule[q].b, q, made);
    return made;
  }();
  return shapes;
}

template <>
const CellShapes<3>& cell_shapes<3>() {
  static const CellShapes<3> shapes = [] {
    CellShapes<3> made;
    const auto& rule = triangle_rule(4);
    for (int q = 0; q < cell_points; ++q) {
      made.value.row(q) << 1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b;
      made.derivative_a.row(q) << -1, 1, 0;
      made.derivative_b.row(q) << -1, 0, 1;
    }
    return made;
  }();
  return shapes;
}

}  // namespace parison::core
