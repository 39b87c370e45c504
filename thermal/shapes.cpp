// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/shapes.hpp"

namespace parison::thermal {

const CellShapes& cell_shapes() {
  static const CellShapes shapes = [] {
    CellShapes made;
    const auto& rule = core::triangle_rule(4);
    for (std::size_t q = 0; q < made.size(); ++q) made[q] = core::triangle_shape(rule[q].a, rule[q].b);
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
