// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/ray_exchange.hpp"

#include <algorithm>

#include "thermal/radiation/light_heat.hpp"
#include "thermal/radiation/rays/traced_rays.hpp"
#include "thermal/system.hpp"

namespace parison::thermal {

namespace {

/// Adds the numbers at the quadrature points times the functions of the zones.
Eigen::VectorXd to_zones(const TracedRays& traced, const Field& values) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(traced.zones.function_count());
  for (std::size_t b = 0; b < values.size(); ++b)
    for (int q = 0; q < core::cell_points; ++q)
      for (int lane = 0; lane < core::batch_size; ++lane) {
        double* zone = &sum[zone_functions * traced.zone[b][q][lane]];
        for (int i = 0; i < zone_functions; ++i) zone[i] += traced.values[b][i][q][lane] * values[b][q][lane];
      }
  return sum;
}

/// Adds a correction to the constant of each zone and to each patch so that a body in equilibrium stays in it. As the
/// factors are symmetric, it then also balances. `functions` are what equilibrium has there, `emitted` what they send.
void close(ExchangeFactors& factors, const Eigen::VectorXd& functions, const Eigen::VectorXd& emitted,
           const Eigen::ArrayXd& area) {
  const Eigen::Index zones = functions.size(), patches = area.size();
  Eigen::VectorXd in_equilibrium(zones + patches), wanted(zones + patches);
  in_equilibrium << functions, Eigen::VectorXd::Ones(patches);
  wanted << emitted, area.matrix();
  const Eigen::VectorXd missing = wanted - factors * in_equilibrium;
  for (Eigen::Index z = 0; z < zones; z += zone_functions) {
    double rest = missing[z];
    for (int i = 1; i < zone_functions; ++i) {
      const double slope = missing[z + i] / functions[z];
      factors(z + i, z) += slope;
      factors(z, z + i) += slope;
      rest -= slope * functions[z + i];
    }
    factors(z, z) += rest / functions[z];
  }
  for (Eigen::Index p = zones; p < zones + patches; ++p) factors(p, p) += missing[p];
}

/// Areas of the patches and what of the light out of them comes back.
void set_surface(RayExchange& rays, const Light& light, const HeatSystem& system) {
  const core::Mesh& mesh = *system.problem->bodies[light.body].mesh;
  const TracedRays& traced = *rays.traced;
  rays.area.setZero(traced.patches);
  std::vector<Index> patch_of(mesh.nodes.size(), -1);  // by mid-side node
  for (std::size_t e = 0; e < traced.surface.size(); ++e) {
    const Index patch = traced.surface[e].patch;
    const auto& nodes = mesh.boundary_edges()[e].nodes;
    patch_of[nodes[2]] = patch;
    if (patch < 0) continue;
    for (const auto& at : core::edge_rule(3))
      rays.area[patch] += core::map_edge_point(mesh, nodes, system.problem->geometry, at).area;
  }
  Eigen::ArrayXd covered = Eigen::ArrayXd::Zero(traced.patches);
  std::vector<char> open(traced.patches, 0);
  rays.returned.setZero(traced.patches);
  for (const LightEdge& edge : light.edges) open[rays.edge_patch.emplace_back(patch_of[edge.mid_node])] = 1;
  for (std::size_t i = 0; i < light.contacts.size(); ++i) {
    const Index patch = rays.contact_patch.emplace_back(patch_of[system.problem->interface[i].slave_nodes[2]]);
    const double area = system.interface.area[static_cast<Index>(i)];
    covered[patch] += area;
    rays.returned[patch] += (1 - light.contacts[i].emissivity) * area;
  }
  for (Index p = 0; p < traced.patches; ++p)
    rays.returned[p] = (rays.returned[p] + (open[p] ? 0 : std::max(0.0, rays.area[p] - covered[p]))) / rays.area[p];
}

/// Absorption at the quadrature points over that of their zones as traced; empty where it is 1.
Field share_of_zones(const Light& light, const TracedRays& traced, int k) {
  const Field* relative = light.relative_of(k);
  if (!relative) return {};
  Field share = *relative;
  for (std::size_t b = 0; b < share.size(); ++b)
    for (int q = 0; q < core::cell_points; ++q)
      for (int lane = 0; lane < core::batch_size; ++lane)
        share[b][q][lane] *= light.laws().group(k).absorption / traced.absorption[k][traced.zone[b][q][lane]];
  return share;
}

/// What each function of a zone has from its zone.
Eigen::VectorXd by_function(const Eigen::VectorXd& by_zone) {
  return by_zone.transpose().replicate(zone_functions, 1).reshaped();
}

}  // namespace

RayExchange make_ray_exchange(const Light& light, const HeatSystem& system, KeptTraces<TracedRays>& kept) {
  const std::shared_ptr<const TracedRays> traced = trace_where_changed(light, system, kept);
  RayExchange rays{traced, {}, {}, {}, {}, {}};
  set_surface(rays, light, system);
  const double square = std::pow(light.kept->radiation.refractive_index, 2);
  const Eigen::Index patches = traced->patches;
  for (std::size_t k = 0; k < traced->factors.size(); ++k) {
    RayBand band{share_of_zones(light, *traced, static_cast<int>(k)), traced->factors[k], {}};
    const Eigen::VectorXd functions =
        to_zones(*traced, band.share.empty() ? light.volumes : product(light.volumes, band.share));
    close(band.factors, functions, 4 * square * by_function(traced->absorption[k]).cwiseProduct(traced->zones.one()),
          rays.area);
    if ((rays.returned > 0).any()) {
      const Eigen::MatrixXd back =
          (rays.returned / rays.area).matrix().asDiagonal() * band.factors.bottomRightCorner(patches, patches);
      band.from_outside.emplace(Eigen::MatrixXd::Identity(patches, patches) - back);
    }
    rays.bands.push_back(std::move(band));
  }
  return rays;
}

namespace {

/// Light that comes in from outside, W by patch, with what the tools then send back, W/m2.
Eigen::VectorXd from_outside(const RayExchange& rays, int k, const Eigen::VectorXd& light) {
  const Eigen::VectorXd added = light.cwiseQuotient(rays.area.matrix());
  return rays.bands[k].from_outside ? rays.bands[k].from_outside->solve(added).eval() : added;
}

}  // namespace

GroupLight ray_light(const Light& light, int k, const GroupSource& source) {
  const RayExchange& rays = *light.rays;
  const TracedRays& traced = *rays.traced;
  const ExchangeFactors& factors = rays.bands[k].factors;
  const Eigen::Index zones = traced.zones.function_count(), patches = traced.patches;
  const double scale = 4 * std::pow(light.kept->radiation.refractive_index, 2);  // from emissive power to irradiation
  Eigen::VectorXd sent(zones + patches);
  sent.head(zones) =
      to_zones(traced, source.cells).cwiseQuotient(scale * by_function(traced.absorption[static_cast<std::size_t>(k)]));
  auto outside = sent.tail(patches);
  outside.setZero();
  for (std::size_t e = 0; e < light.edges.size(); ++e)
    for (const double value : source.edges[e]) outside[rays.edge_patch[e]] += value;
  for (std::size_t i = 0; i < light.contacts.size(); ++i)
    outside[rays.contact_patch[i]] += source.contacts[static_cast<Index>(i)];
  outside.array() /= rays.area;
  if (rays.bands[k].from_outside) {
    const Eigen::VectorXd out = factors.bottomLeftCorner(patches, zones) * sent.head(zones);
    outside =
        rays.bands[k].from_outside->solve(outside + (rays.returned / rays.area).matrix().cwiseProduct(out)).eval();
  }
  Eigen::VectorXd taken = factors * sent;
  GroupLight result{Field(light.volumes.size()), {}, Eigen::ArrayXd(source.contacts.size())};
  if (light.enclosure) {
    result.excess = ray_excess(*light.enclosure, k, rays.area, taken.tail(patches), source.patches);
    taken += factors.rightCols(patches) * from_outside(rays, k, light.enclosure->shared * result.excess);
  }
  for (std::size_t b = 0; b < result.absorbed.size(); ++b)
    for (int q = 0; q < core::cell_points; ++q) {
      PointValues& values = result.absorbed[b];
      values[q] = VectorizedArray{};
      for (int lane = 0; lane < core::batch_size; ++lane) {
        const double* zone = &taken[zone_functions * traced.zone[b][q][lane]];
        for (int i = 0; i < zone_functions; ++i) values[q][lane] += traced.values[b][i][q][lane] * zone[i];
      }
      values[q] *= light.volumes[b][q];
      if (!rays.bands[k].share.empty()) values[q] *= rays.bands[k].share[b][q];
    }
  const Eigen::ArrayXd at_surface = scale * taken.tail(patches).array() / rays.area;
  for (const Index patch : rays.edge_patch)
    result.edges.push_back({at_surface[patch], at_surface[patch], at_surface[patch]});
  for (std::size_t i = 0; i < light.contacts.size(); ++i)
    result.contacts[static_cast<Index>(i)] = at_surface[rays.contact_patch[i]];
  return result;
}

}  // namespace parison::thermal
