// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/traced_rays.hpp"

#include <algorithm>

#include "thermal/system.hpp"

namespace parison::thermal {

Field product(Field a, const Field& b) {
  for (std::size_t g = 0; g < a.size(); ++g)
    for (int q = 0; q < core::cell_points; ++q) a[g][q] *= b[g][q];
  return a;
}

namespace {

constexpr int cells_of_zone = 3;  ///< of the mesh, at the least
constexpr double moved_far = 1;   ///< distance, of a box, that the glass moves before rays are traced anew
constexpr double changed = 0.02;  ///< share by which the absorption of a zone changes before that

/// By boundary of the glass: a mirror where it is neither open nor black nor touched.
std::vector<SurfaceKind> surface_kinds(const Light& light, const HeatSystem& system) {
  const BodyView& body = system.problem->bodies[light.body];
  std::vector<SurfaceKind> kinds;
  for (std::size_t b = 0; b < body.mesh->boundaries().size(); ++b)
    kinds.push_back(!body.prescribed.empty() && body.prescribed[b] ? SurfaceKind::black
                    : body.light.surroundings[b]                   ? SurfaceKind::open
                                                                   : SurfaceKind::mirror);
  for (const LightContact& contact : light.contacts)
    if (kinds[contact.boundary] == SurfaceKind::mirror) kinds[contact.boundary] = SurfaceKind::open;
  return kinds;
}

/// Patches as long as a box or, where edges are longer, as those.
std::vector<RaySurface> divide_surface(const core::Mesh& mesh, const std::vector<SurfaceKind>& kinds, double length,
                                       Index& patches) {
  std::vector<RaySurface> surface;
  double so_far = 0;
  Index last = -1;
  patches = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const SurfaceKind kind = kinds[edge.boundary_id];
    if (kind == SurfaceKind::mirror) {
      surface.push_back({-1, false});
      last = -1;
      continue;
    }
    const double own = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    if (last != edge.boundary_id || so_far + 0.5 * own > length) ++patches, so_far = 0;
    so_far += own;
    last = edge.boundary_id;
    surface.push_back({patches - 1, kind == SurfaceKind::black});
  }
  return surface;
}

/// Calls what(batch, point, lane, shape functions, cell) for each quadrature point.
template <typename What>
void for_each_point(const core::Mesh& mesh, What&& what) {
  for (Index b = 0; b < core::batch_count(mesh.cell_count()); ++b)
    for (int lane = 0; lane < core::filled_lanes(mesh.cell_count(), b); ++lane)
      for (int q = 0; q < core::cell_points; ++q) {
        Point x = Point::Zero();
        const auto& nodes = mesh.cells()[b * core::batch_size + lane];
        for (int i = 0; i < 6; ++i) x += cell_shapes<6>().value(q, i) * mesh.nodes[nodes[i]];
        what(b, q, lane, x);
      }
}

Zones make_zones(const Field& volumes, const core::Mesh& mesh, Geometry geometry, int most_zones) {
  std::vector<Point> position;
  std::vector<double> volume, area;
  for_each_point(mesh, [&](Index b, int q, int lane, const Point& x) {
    position.push_back(x);
    volume.push_back(volumes[b][q][lane]);
    const double depth = core::depth(geometry, x);
    area.push_back(depth > 0 ? volume.back() / depth : 0);
  });
  return {position, volume, area, std::clamp(mesh.cell_count() / cells_of_zone, 1, most_zones)};
}

/// Adds the numbers at the quadrature points to the zones that they lie in.
Eigen::VectorXd sum_in_zones(const TracedRays& traced, const Field& values) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(traced.zones.size());
  for (std::size_t b = 0; b < values.size(); ++b)
    for (int q = 0; q < core::cell_points; ++q)
      for (int lane = 0; lane < core::batch_size; ++lane) sum[traced.zone[b][q][lane]] += values[b][q][lane];
  return sum;
}

/// Absorption of each band in each zone, 1/m: the mean over the volumes of the quadrature points, m3.
std::vector<Eigen::VectorXd> zone_absorption(const Light& light, const TracedRays& traced, const Field& volumes) {
  std::vector<Eigen::VectorXd> absorption;
  for (int k = 0; k < light.laws().group_count(); ++k) {
    absorption.emplace_back(Eigen::VectorXd::Constant(traced.zones.size(), light.laws().group(k).absorption));
    if (const Field* relative = light.relative_of(k))
      absorption.back().array() *=
          sum_in_zones(traced, product(volumes, *relative)).array() / sum_in_zones(traced, volumes).array();
  }
  return absorption;
}

/// Traces the rays on a mesh of the body, whose quadrature points have these volumes, m3; `given` are the absorption
/// coefficients of the zones, 1/m, band after band, empty for the present ones.
std::shared_ptr<const TracedRays> trace(const Light& light, const HeatSystem& system, const core::Mesh& mesh,
                                        const Field& volumes, const std::vector<SurfaceKind>& kinds,
                                        const std::vector<double>& given) {
  const Geometry geometry = system.problem->geometry;
  const LightResolution& resolution = system.problem->light_resolution;
  auto traced = std::make_shared<TracedRays>(TracedRays{
      mesh.nodes, mesh.cells(), kinds, make_zones(volumes, mesh, geometry, resolution.zones()), {}, 0, {}, {}, {}, {}});
  traced->surface = divide_surface(mesh, kinds, traced->zones.box_size(), traced->patches);
  traced->zone.assign(volumes.size(), {});
  traced->values.assign(volumes.size(), {});
  for_each_point(mesh, [&](Index b, int q, int lane, const Point& x) {
    const Index zone = traced->zone[b][q][lane] = traced->zones.at(x);
    const ZoneValues values = traced->zones.values(zone, x);
    for (int i = 0; i < zone_functions; ++i) traced->values[b][i][q][lane] = values[i];
  });
  traced->absorption = zone_absorption(light, *traced, volumes);
  auto next = given.begin();
  for (Eigen::VectorXd& band : traced->absorption)
    for (double& kappa : band)
      if (!given.empty()) kappa = *next++;
  traced->factors = trace_exchange(mesh, geometry, traced->zones, traced->surface, traced->patches,
                                   light.kept->radiation.refractive_index, traced->absorption, resolution);
  return traced;
}

/// Whether the zones had these coefficients, band after band; empty: what they always have.
bool has_absorption(const TracedRays& traced, const std::vector<double>& given) {
  auto next = given.begin();
  for (const Eigen::VectorXd& band : traced.absorption)
    for (const double kappa : band)
      if (!given.empty() && kappa != *next++) return false;
  return true;
}

/// Goes back to the rays that were traced at given places.
void recall(KeptTraces<TracedRays>& kept, const Light& light, const HeatSystem& system, const TracedPlaces& at) {
  if (at.rays.empty()) {
    kept = {};
    return;
  }
  std::vector<SurfaceKind> kinds;
  for (const Index kind : at.surfaces) kinds.push_back(static_cast<SurfaceKind>(kind));
  kept.recall(
      [&](const TracedRays& traced) {
        return traced.nodes == at.rays && traced.kinds == kinds && has_absorption(traced, at.absorption);
      },
      [&] {
        BodyView body = system.problem->bodies[light.body];
        core::Mesh mesh = *body.mesh;
        mesh.nodes = at.rays;
        body.mesh = &mesh;
        return trace(light, system, mesh, make_volumes(body, system.problem->geometry), kinds, at.absorption);
      });
}

bool is_near(const TracedRays& traced, const core::Mesh& mesh) {
  if (traced.cells != mesh.cells()) return false;
  const double far = moved_far * traced.zones.box_size();
  const Point shift = mesh.nodes.front() - traced.nodes.front();
  const Point along(0, shift[1]);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (!((mesh.nodes[i] - traced.nodes[i] - along).squaredNorm() < far * far)) return false;
  return true;
}

/// Whether the zones absorb nearly as they did.
bool absorbs_alike(const TracedRays& traced, const Light& light) {
  if (light.relative.empty()) return true;
  const std::vector<Eigen::VectorXd> now = zone_absorption(light, traced, light.volumes);
  for (std::size_t k = 0; k < now.size(); ++k)
    if (!((now[k].array() / traced.absorption[k].array() - 1).abs() < changed).all()) return false;
  return true;
}

}  // namespace

std::shared_ptr<const TracedRays> trace_where_changed(const Light& light, const HeatSystem& system,
                                                      KeptTraces<TracedRays>& kept) {
  const core::Mesh& mesh = *system.problem->bodies[light.body].mesh;
  const std::vector<SurfaceKind> kinds = surface_kinds(light, system);
  if (system.problem->traced) recall(kept, light, system, *system.problem->traced);
  if (!kept.last || kept.last->kinds != kinds || !is_near(*kept.last, mesh) || !absorbs_alike(*kept.last, light))
    kept.add(trace(light, system, mesh, light.volumes, kinds, {}));
  return kept.last;
}

}  // namespace parison::thermal
