// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/linearise.hpp"

#include "thermal/shapes.hpp"

namespace parison::thermal {

namespace {

template <int N>
void linearise_cell(const BodyLaws& laws, const HeatCell& cell, const Eigen::VectorXd& temperature,
                    CellSlopes& slopes) {
  const CellShapes<N>& shapes = cell_shapes<N>();
  const auto T = gather<N>(temperature, cell.unknowns);
  const PointArray at = shapes.value * T, along_a = shapes.slope_a * T, along_b = shapes.slope_b * T;
  const PointArray dk_dT = laws.conductivity.slope(at, cell.thin_wall);
  slopes = {cell.mass * laws.enthalpy.capacity(at), laws.conductivity(at, cell.thin_wall),
            dk_dT * (cell.aa * along_a + cell.ab * along_b), dk_dT * (cell.ab * along_a + cell.bb * along_b)};
}

template <int N>
void apply_cell(const HeatCell& cell, const CellSlopes& slopes, double step, const Eigen::VectorXd& change,
                Eigen::VectorXd& result) {
  const CellShapes<N>& shapes = cell_shapes<N>();
  const auto d = gather<N>(change, cell.unknowns);
  const PointArray at = shapes.value * d, along_a = shapes.slope_a * d, along_b = shapes.slope_b * d;
  const PointArray& k = slopes.conductivity;
  const PointArray flow_a = step * (k * (cell.aa * along_a + cell.ab * along_b) + slopes.flow_a * at);
  const PointArray flow_b = step * (k * (cell.ab * along_a + cell.bb * along_b) + slopes.flow_b * at);
  const PointArray stored = slopes.capacity * at;
  scatter<N>(shapes.value_back * stored.matrix() + shapes.slope_a_back * flow_a.matrix() +
                 shapes.slope_b_back * flow_b.matrix(),
             cell.unknowns, result);
}

}  // namespace

Linearisation linearise(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  Linearisation result;
  result.cells.resize(system.cells.size());
  const auto cell = system.problem->order == 2 ? linearise_cell<6> : linearise_cell<3>;
  for (const BodyLaws& laws : system.bodies)
    for (Index c = laws.first_cell; c < laws.last_cell; ++c) cell(laws, system.cells[c], temperature, result.cells[c]);
  linearise_exchange(system, temperature, result);
  return result;
}

Eigen::VectorXd apply(const HeatSystem& system, const Linearisation& linearisation, double step,
                      const Eigen::VectorXd& change) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(system.size());
  const auto cell = system.problem->order == 2 ? apply_cell<6> : apply_cell<3>;
  for (std::size_t c = 0; c < system.cells.size(); ++c)
    cell(system.cells[c], linearisation.cells[c], step, change, result);
  apply_exchange(system, linearisation, step, change, result);
  return result;
}

}  // namespace parison::thermal
