// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light_heat.hpp"
#include "thermal/radiation/rays/traced_rays.hpp"
#include "thermal/system.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

namespace {

/// Share of a derivative of the emission that stands in the matrix of modified Newton: none to all of the light is
/// absorbed again, so the matrix is never off by more than half.
constexpr double not_absorbed_again = 0.5;

/// Emissive powers of the patches when the temperatures change.
PatchEmission changed_patches(const Enclosure& enclosure, const Eigen::ArrayXd& slope, const Eigen::VectorXd& change) {
  const Eigen::ArrayXd emitted = patch_means(enclosure, [&](std::size_t i) {
    const EnclosurePoint& point = enclosure.points[i];
    return slope[static_cast<Eigen::Index>(i)] * interpolate(change, point.unknowns.data(), point.shape);
  });
  return {emitted, Eigen::ArrayXd::Zero(emitted.size())};
}

void add_excess_change(const Light& light, const HeatSystem& system, const GroupLight& found, double step,
                       Eigen::VectorXd& result) {
  const Eigen::ArrayXd absorbed = absorbed_excess(light, system, found);
  for (const EnclosurePoint& point : system.enclosure->points) {
    if (system.enclosure->patches[static_cast<std::size_t>(point.patch)].body == light.body) continue;
    for (int i = 0; i < 3; ++i) result[point.unknowns[i]] -= step * point.shape[i] * point.area * absorbed[point.patch];
  }
}

/// Derivatives of the surface, all but the emission of the cells.
void linearise_surface(const Light& light, const HeatSystem& system, const Eigen::VectorXd& temperature,
                       LightDerivatives& result) {
  const LightLaws& laws = light.laws();
  const SideTemperatures sides = side_temperatures(system.interface, temperature);
  const double emissivity = system.problem->bodies[light.body].light.emissivity;
  for (const LightEdge& edge : light.edges) {
    auto& slope = result.opaque_edge.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = at_point(temperature, edge.temperature, edge.shape[q].data());
      slope[q] = edge.black ? 0 : emissivity * edge.area[q] * laws.opaque_emission(T).derivative;
    }
  }
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const LightContact& contact = light.contacts[i];
    const auto at = static_cast<Index>(i);
    const double area = system.interface.area[at], master = sides.master[at];
    const double own = area * laws.opaque_emission(sides.slave[at]).derivative;
    result.opaque_slave[at] = contact.opaque * own;
    result.opaque_open[at] = contact.opaque_open * own;
    result.opaque_master[at] = contact.opaque * area * laws.opaque_emission(master).derivative;
    for (int k = 0; k < laws.group_count(); ++k)
      result.from_tool[k][at] = light.to_tool(k, contact) * area * laws.irradiation(k, master).derivative;
  }
}

}  // namespace

LightDerivatives linearise_light(const Light& light, const HeatSystem& system, const Eigen::VectorXd& temperature) {
  const auto points = static_cast<Eigen::Index>(light.contacts.size());
  LightDerivatives result;
  result.opaque_slave = result.opaque_master = result.opaque_open = Eigen::ArrayXd::Zero(points);
  result.from_tool.assign(light.laws().group_count(), Eigen::ArrayXd::Zero(points));
  const Field at_cells = at_cell_points(light, system, temperature);
  for (int k = 0; k < light.laws().group_count(); ++k)
    result.emission.push_back(emission_at(light, k, at_cells, &Emission::derivative));
  linearise_surface(light, system, temperature, result);
  for (int k = 0; light.enclosure && k < light.laws().group_count(); ++k) {
    auto& slope = result.from_surfaces.emplace_back(static_cast<Eigen::Index>(system.enclosure->points.size()));
    for (Eigen::Index i = 0; i < slope.size(); ++i) {
      const EnclosurePoint& point = system.enclosure->points[static_cast<std::size_t>(i)];
      slope[i] =
          light.laws().emissive_power(k, interpolate(temperature, point.unknowns.data(), point.shape)).derivative;
    }
  }
  return result;
}

void apply_light(const Light& light, const HeatSystem& system, const LightDerivatives& derivatives, double step,
                 const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  const SideTemperatures sides = side_temperatures(system.interface, change);
  const Field at_cells = at_cell_points(light, system, change);
  Eigen::ArrayXd to_tool = derivatives.opaque_slave * sides.slave - derivatives.opaque_master * sides.master;
  const Eigen::ArrayXd opaque = to_tool - derivatives.opaque_open * sides.slave;
  for (int k = 0; k < light.laws().group_count(); ++k) {
    const Eigen::ArrayXd from_tool = derivatives.from_tool[k] * sides.master;
    GroupSource source{product(derivatives.emission[k], at_cells),
                       std::vector<std::array<double, 3>>(light.edges.size(), {0, 0, 0}), from_tool};
    if (light.enclosure) source.patches = changed_patches(*system.enclosure, derivatives.from_surfaces[k], change);
    const GroupLight found = solve_group(light, k, source);
    for (std::size_t i = 0; i < light.contacts.size(); ++i) {
      const auto at = static_cast<Index>(i);
      to_tool[at] +=
          light.to_tool(k, light.contacts[i]) * system.interface.area[at] * found.contacts[at] - from_tool[at];
    }
    add_absorbed(light, system, source, found, -step, result);
    if (light.enclosure) add_excess_change(light, system, found, step, result);
  }
  for (std::size_t e = 0; e < light.edges.size(); ++e) {
    const LightEdge& edge = light.edges[e];
    for (int q = 0; q < 3; ++q) {
      const double* shape = edge.shape[q].data();
      add_at_point(step * derivatives.opaque_edge[e][q] * at_point(change, edge.temperature, shape), edge.temperature,
                   shape, result);
    }
  }
  for (const HeatSegment& segment : system.interface.segments)
    for (Index i = segment.first_point; i < segment.last_point; ++i)
      for (int k = 0; k < 6; ++k)
        result[segment.unknowns[k]] += step * system.interface.shape(k, i) * (k < 3 ? opaque[i] : -to_tool[i]);
}

namespace {

/// Weighted mass matrix of the emission of each cell.
void add_cells(StepMatrix& matrix, const Light& light, const HeatSystem& system, const LightDerivatives& derivatives,
               double step) {
  const auto& shapes = cell_shapes<6>().value;
  const BodyLaws& body = system.bodies[light.body];
  for (Index c = body.first_cell; c < body.last_cell; ++c) {
    const Index batch = (c - body.first_cell) / batch_size, lane = (c - body.first_cell) % batch_size;
    std::array<double, 36> local{};
    for (int q = 0; q < core::cell_points; ++q) {
      double slope = 0;
      for (const Field& group : derivatives.emission) slope += group[batch][q][static_cast<int>(lane)];
      slope *= step * not_absorbed_again;
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j) local[6 * i + j] += slope * shapes(q, i) * shapes(q, j);
    }
    add_clique(matrix, system, c, 6, system.cells[c].data(), local.data());
  }
}

}  // namespace

void assemble_light(StepMatrix& matrix, const Light& light, const HeatSystem& system,
                    const Eigen::VectorXd& temperature, double step) {
  const LightDerivatives derivatives = linearise_light(light, system, temperature);
  add_cells(matrix, light, system, derivatives, step);
  for (std::size_t e = 0; e < light.edges.size(); ++e) {
    const LightEdge& edge = light.edges[e];
    const auto& [a, b, c] = derivatives.opaque_edge[e];
    add_edge(matrix, system, edge.boundary_edge, edge.temperature, {step * a, step * b, step * c}, edge.shape);
  }
  Eigen::ArrayXd master = derivatives.opaque_master;
  for (const Eigen::ArrayXd& group : derivatives.from_tool) master += group;
  const Eigen::ArrayXd slave = derivatives.opaque_slave - derivatives.opaque_open;
  for (std::size_t k = 0; k < system.interface.segments.size(); ++k) {
    const HeatSegment& segment = system.interface.segments[k];
    Eigen::Matrix<double, 6, 6, Eigen::RowMajor> local = Eigen::Matrix<double, 6, 6>::Zero();
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const Eigen::Vector3d s = system.interface.shape.col(i).head<3>(), m = system.interface.shape.col(i).tail<3>();
      local.topLeftCorner<3, 3>() += step * slave[i] * s * s.transpose();
      local.bottomRightCorner<3, 3>() += step * master[i] * m * m.transpose();
    }
    add_clique(matrix, system, matrix.segment_clique[k], 6, segment.unknowns.data(), local.data());
  }
}

}  // namespace parison::thermal
