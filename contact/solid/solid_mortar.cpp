// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/solid_mortar.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/mortar/mortar.hpp"
#include "contact/solid/face_plane.hpp"
#include "contact/solid/face_search.hpp"
#include "core/mesh/element.hpp"

namespace parison::contact {

namespace {

constexpr double least_opposition = 0.3;  ///< cosine of the angle up to which normals look at each other
constexpr double least_segment = 1e-10;   ///< share of the slave's face below which a segment is left out

/// A slave face and its plane.
struct SlaveFace {
  const SolidSurface& surface;
  Index face;
  FacePlane plane;
  ProjectedFace projected;
  Polygon polygon;
  double polygon_area;

  SlaveFace(const SolidSurface& of, Index number)
      : surface(of),
        face(number),
        plane(*of.nodes, (*of.faces)[number]),
        projected(plane, *of.nodes, (*of.faces)[number]),
        polygon(outline(projected, false)),
        polygon_area(area(polygon)) {}
  const core::QuadFace& quad() const { return (*surface.faces)[face]; }
};

/// A master face as a slave face sees it.
struct Opposite {
  Index master, face;
  ProjectedFace projected;
  Polygon polygon;  ///< by the corners
  Polygon segment;  ///< what it has in common with the slave
};

/// A quadrature point of a slave face, in its plane.
struct PlanePoint {
  Point at;
  double area;  ///< of the slave, m2
  std::array<double, 2> place;
  Vector3 position;
};

/// Calls visit(point) for the points of a polygon that the slave's map reaches.
template <typename Visit>
void for_each_point(const SlaveFace& slave, const Polygon& polygon, int degree, const Visit& visit) {
  std::array<double, 2> place{0.5, 0.5};
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Point u = polygon[k] - polygon[0], v = polygon[k + 1] - polygon[0];
    const double twice = core::cross(u, v);
    if (std::abs(twice) < least_segment * slave.polygon_area) continue;
    for (const auto& rule : core::triangle_rule(degree)) {
      const Point at = polygon[0] + rule.a * u + rule.b * v;
      const auto found = slave.projected.invert(at, place);
      if (!found) continue;
      place = *found;
      const core::FacePlace on = core::face_place(*slave.surface.nodes, slave.quad(), place[0], place[1]);
      const double stretch = on.area().norm() / on.area().dot(slave.plane.normal);
      visit(PlanePoint{at, rule.weight * twice * stretch, place, on.position});
    }
  }
}

double exact_area(const SolidSurface& surface, const core::QuadFace& face) {
  const auto& rule = core::edge_rule(3);
  double sum = 0;
  for (const auto& a : rule)
    for (const auto& b : rule)
      sum += a.weight * b.weight * core::face_place(*surface.nodes, face, a.s, b.s).area().norm();
  return sum;
}

/// By how much the polygon of a slave face with bent edges misses its area.
double area_correction(const SlaveFace& slave, int degree) {
  if (slave.polygon.size() == 4) return 1;
  double sum = 0;
  for_each_point(slave, slave.polygon, degree, [&](const PlanePoint& point) { sum += point.area; });
  return sum > 0 ? exact_area(slave.surface, slave.quad()) / sum : 1;
}

/// The masters' faces with the search for them.
struct Opponents {
  const std::vector<SolidMaster>& masters;
  std::vector<BoxSearch> search;  ///< by master, over its touching faces
};

/// Place on a master's face opposite a point of the slave, and the distance of the faces there along the normal.
struct Facing {
  std::array<double, 2> place;
  double distance;  ///< m
};
std::optional<Facing> facing(const SlaveFace& slave, const PlanePoint& point, const SolidSurface& master,
                             const Opposite& opposite) {
  const auto place = opposite.projected.invert(point.at);
  if (!place) return std::nullopt;
  const core::FacePlace on = core::face_place(*master.nodes, (*master.faces)[opposite.face], (*place)[0], (*place)[1]);
  return Facing{*place, slave.plane.height(on.position) - slave.plane.height(point.position)};
}

std::vector<Opposite> opposites_of(const SlaveFace& slave, const Opponents& opponents, double reach) {
  const SpaceBox box = box_around(*slave.surface.nodes, slave.quad(), reach);
  std::vector<Opposite> found;
  for (std::size_t m = 0; m < opponents.masters.size(); ++m) {
    const SolidSurface& surface = opponents.masters[m].surface;
    for (const Index at : opponents.search[m].find(box)) {
      const Index face = surface.touching[at];
      const core::QuadFace& quad = (*surface.faces)[face];
      if (FacePlane(*surface.nodes, quad).normal.dot(slave.plane.normal) > -least_opposition) continue;
      Opposite opposite{static_cast<Index>(m), face, ProjectedFace(slave.plane, *surface.nodes, quad), {}, {}};
      for (const int corner : {0, 6, 8, 2}) opposite.polygon.push_back(opposite.projected.node(corner));
      opposite.segment = clip(slave.polygon, opposite.polygon);
      if (opposite.segment.size() < 3 || area(opposite.segment) < least_segment * slave.polygon_area) continue;
      found.push_back(std::move(opposite));
    }
  }
  return found;
}

/// Whether another face is nearer at a point; of equal ones the first counts.
bool is_hidden(const SlaveFace& slave, const PlanePoint& point, const std::vector<SolidMaster>& masters,
               const std::vector<Opposite>& opposites, std::size_t own, double distance) {
  for (std::size_t k = 0; k < opposites.size(); ++k) {
    if (k == own || !holds(opposites[k].polygon, point.at)) continue;
    const auto other = facing(slave, point, masters[opposites[k].master].surface, opposites[k]);
    if (!other) continue;
    const double nearer = std::abs(other->distance) - std::abs(distance);
    if (nearer < 0 || (nearer == 0 && k < own)) return true;
  }
  return false;
}

/// All pairs and points of one slave face.
void add_slave_face(const SlaveFace& slave, const Opponents& opponents, const SolidMortarOptions& options,
                    core::SolidInterface& interface) {
  const std::vector<Opposite> opposites = opposites_of(slave, opponents, options.reach);
  if (opposites.empty()) return;
  const double correction = area_correction(slave, options.degree);
  double covered = 0;
  for (const Opposite& opposite : opposites) covered += area(opposite.segment);
  const bool overlap = covered > (1 + 1e-6) * slave.polygon_area;
  for (std::size_t k = 0; k < opposites.size(); ++k) {
    const Opposite& opposite = opposites[k];
    const SolidMaster& master = opponents.masters[opposite.master];
    const auto pair = static_cast<Index>(interface.pairs.size());
    bool near = false;
    for_each_point(slave, opposite.segment, options.degree, [&](const PlanePoint& point) {
      const auto on = facing(slave, point, master.surface, opposite);
      if (!on || !(std::abs(on->distance) <= options.reach)) return;
      near = true;
      const ContactState state =
          master.contact ? master.contact(slave.face, point.place) : ContactState{on->distance, 0};
      const double weight = contact_weight(state.gap, master.transition_gap);
      if (!(weight > 0)) return;
      if (overlap && is_hidden(slave, point, opponents.masters, opposites, k, on->distance)) return;
      interface.points.push_back({pair, core::quad_shape(point.place[0], point.place[1]),
                                  core::quad_shape(on->place[0], on->place[1]), point.place, point.position,
                                  correction * point.area, state.gap, weight, state.pressure, master.law, state.opening,
                                  state.closing_rate});
    });
    if (near) interface.pairs.push_back({slave.surface.body, slave.face, master.surface.body, opposite.face});
  }
}

}  // namespace

SolidSurface solid_surface(Index body, const std::vector<Vector3>& nodes, const std::vector<core::QuadFace>& faces,
                           const std::vector<Index>& boundaries) {
  SolidSurface surface{body, &nodes, &faces, {}};
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (boundaries.empty() || std::count(boundaries.begin(), boundaries.end(), faces[f].boundary_id) > 0)
      surface.touching.push_back(static_cast<Index>(f));
  return surface;
}

core::SolidInterface build_interface(const SolidSurface& slave, const std::vector<SolidMaster>& masters,
                                     const SolidMortarOptions& options) {
  Opponents opponents{masters, {}};
  for (const SolidMaster& master : masters) {
    std::vector<SpaceBox> boxes;
    for (const Index face : master.surface.touching)
      boxes.push_back(box_around(*master.surface.nodes, (*master.surface.faces)[face], 0));
    opponents.search.emplace_back(std::move(boxes));
  }
  core::SolidInterface interface;
  for (const Index face : slave.touching) add_slave_face(SlaveFace(slave, face), opponents, options, interface);
  return interface;
}

}  // namespace parison::contact
