// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_problem.hpp"

#include <utility>

namespace parison::thermal {

namespace {

/// Calls visit(point, temperature) for all points of a body.
template <typename Visit>
void for_each_temperature(const core::CellList& cells, const Eigen::VectorXd& temperature, const Visit& visit) {
  const core::CellTable& table = *cells.table;
  Eigen::VectorXd local(table.nodes()), at(table.points());
  for (Index c = 0; c < cells.count; ++c) {
    for (Index n = 0; n < table.nodes(); ++n) local[n] = temperature[cells.cell(c)[n]];
    at.noalias() = table.shape * local;
    for (Index q = 0; q < table.points(); ++q) visit(c * table.points() + q, at[q]);
  }
}

}  // namespace

SolidBodyView solid_body(const core::HexMesh& mesh, const std::vector<core::QuadFace>& faces,
                         const Eigen::VectorXd& mass, const Material& material) {
  return {&mesh.nodes, core::cell_list(mesh, core::hexahedron_table()), &faces, &mass, &material, {}, {}};
}

SolidBodyView solid_body(const core::PrismMesh& mesh, const Eigen::VectorXd& mass, const Material& material) {
  return {&mesh.nodes, core::cell_list(mesh, core::prism_table()), &mesh.faces, &mass, &material, {}, {}};
}

Eigen::VectorXd point_masses(const std::vector<core::Vector3>& nodes, const core::CellList& cells,
                             const Material& material, const Eigen::VectorXd& temperature) {
  Eigen::VectorXd mass = material.density * core::point_volumes(nodes, cells);
  if (!material.relative_density.x.empty())
    for_each_temperature(cells, temperature,
                         [&](Index point, double T) { mass[point] *= material.relative_density(T); });
  return mass;
}

SolidInterfaceLaw in_space(InterfaceLaw law, std::vector<core::InterfacePoint> points) {
  return [law = std::move(law), points = std::move(points)](
             double time, const std::vector<core::SolidInterfacePoint>&, const InterfaceTemperatures& temperature,
             Eigen::ArrayXd& h, Eigen::ArrayXd* dh_dT) { law(time, points, temperature, h, dh_dT); };
}

double heat_content(const SolidBodyView& body, const Eigen::VectorXd& temperature) {
  const Enthalpy enthalpy(body.material->heat_capacity);
  double content = 0;
  for_each_temperature(body.cells, temperature,
                       [&](Index point, double T) { content += (*body.mass)[point] * enthalpy(T).h; });
  return content;
}

}  // namespace parison::thermal
