// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_system.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/mesh/element.hpp"
#include "thermal/solid/solid_cells.hpp"
#include "thermal/solid/solid_exchange.hpp"

namespace parison::thermal {

namespace {

SolidLaws laws_of(const SolidBodyView& body, Index first_unknown) {
  const core::CellTable& table = *body.cells.table;
  SolidLaws laws{Enthalpy(body.material->heat_capacity),
                 Conductivity(*body.material),
                 body.cells,
                 core::cell_metric(*body.nodes, body.cells),
                 body.mass,
                 Eigen::MatrixXd(4 * table.points(), table.nodes()),
                 {},
                 first_unknown};
  laws.stacked << table.shape, table.derivative;
  if (!body.wall_thickness || !is_rosseland(*body.material)) return laws;
  laws.thin_wall.resize(body.cells.point_count());
  for (Index c = 0; c < body.cells.count; ++c)
    for (Index q = 0; q < table.points(); ++q) {
      double wall = 0;
      for (Index n = 0; n < table.nodes(); ++n)
        wall += table.shape(q, n) * (*body.wall_thickness)[body.cells.cell(c)[n]];
      laws.thin_wall[c * table.points() + q] = thin_wall_factor(*body.material->radiation, wall);
    }
  return laws;
}

Index boundary_count(const SolidBodyView& body) {
  Index count = static_cast<Index>(std::max(body.exchange.size(), body.prescribed.size()));
  for (const core::QuadFace& face : *body.faces) count = std::max(count, face.boundary_id + 1);
  return count;
}

void add_source(SolidSystem& system, Index body) {
  const Eigen::VectorXd* source = system.problem->bodies[body].source;
  if (!source) return;
  const SolidLaws& laws = system.bodies[body];
  const core::CellTable& table = *laws.cells.table;
  system.body_source[body] = source->sum();
  for (Index c = 0; c < laws.cells.count; ++c) {
    const Eigen::VectorXd into = table.shape.transpose() * source->segment(c * table.points(), table.points());
    for (Index n = 0; n < table.nodes(); ++n) system.source[laws.first_unknown + laws.cells.cell(c)[n]] += into[n];
  }
}

void add_prescribed(SolidSystem& system, Index body) {
  const SolidBodyView& view = system.problem->bodies[body];
  for (const core::QuadFace& face : *view.faces) {
    const auto id = static_cast<std::size_t>(face.boundary_id);
    if (id >= view.prescribed.size() || !view.prescribed[id]) continue;
    for (const Index node : face.nodes)
      prescribe(system, {system.first_unknown[body] + node, body, &*view.prescribed[id],
                         system.first_boundary[body] + face.boundary_id});
  }
}

}  // namespace

SolidSystem make_solid_system(const SolidProblem& problem, const std::vector<Eigen::VectorXd>& temperature) {
  SolidSystem system;
  system.problem = &problem;
  system.first_face = {0};
  std::vector<std::pair<Index, Index>> counts;
  for (const SolidBodyView& body : problem.bodies) {
    counts.emplace_back(static_cast<Index>(body.nodes->size()), boundary_count(body));
    system.first_face.push_back(system.first_face.back() + static_cast<Index>(body.faces->size()));
  }
  number_unknowns(system, counts);
  const Index count = system.body_count();
  for (Index b = 0; b < count; ++b) system.bodies.push_back(laws_of(problem.bodies[b], system.first_unknown[b]));
  for (Index b = 0; b < count; ++b) {
    add_source(system, b);
    add_prescribed(system, b);
    add_faces(system, b);
  }
  add_contacts(system);
  for (Index b = 0; b < count; ++b)
    if (problem.bodies[b].stacks && has_light(*problem.bodies[b].material))
      system.lights.push_back(make_wall_light(system, b, join(system, temperature)));
  return system;
}

std::string why_not_solvable(const SolidSystem& system) {
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    const SolidLaws& laws = system.bodies[b];
    for (Index point = 0; point < laws.metric.volume.size(); ++point)
      if (!(laws.metric.volume[point] > 0))
        return fmt::format("heat: cell {} of body {} is inverted", point / laws.cells.table->points(), b);
  }
  return {};
}

Response evaluate(const SolidSystem& system, double time, const Eigen::VectorXd& temperature) {
  const Eigen::VectorXd factors = source_factors(system.problem->bodies, time),
                        zero = Eigen::VectorXd::Zero(system.size());
  Response response{zero, zero, source_flows(system, factors)};
  for (Index b = 0; b < system.body_count(); ++b) {
    add_cells(system.bodies[b], temperature, response);
    const Index first = system.first_unknown[b], count = system.size_of(b);
    response.power.segment(first, count) += factors[b] * system.source.segment(first, count);
  }
  add_exchange(system, time, temperature, response);
  for (const WallLight& light : system.lights) add_wall_light(light, system, time, temperature, response);
  return response;
}

}  // namespace parison::thermal
