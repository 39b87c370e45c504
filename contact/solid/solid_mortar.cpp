// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/solid_mortar.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
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
        polygon(outline(projected)),
        polygon_area(area(polygon)) {}
  const core::QuadFace& quad() const { return (*surface.faces)[face]; }
};

/// A master face as a slave face sees it.
struct Opposite {
  Index master, face;
  ProjectedFace projected;
  std::vector<Polygon> pieces;
  std::vector<Polygon> segments = {};  ///< what they have in common with the slave
};

/// A quadrature point of a slave face, in its plane.
struct PlanePoint {
  Point at;
  double area;  ///< of the slave, m2
  std::array<double, 2> place;
  Vector3 position;
};

/// Calls visit(triangle) for the triangles of a polygon, but for slivers.
template <typename Visit>
void for_each_triangle(const SlaveFace& slave, const Polygon& polygon, const Visit& visit) {
  for (const Triangle& triangle : triangulate(polygon)) {
    const double twice = core::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    if (std::abs(twice) >= least_segment * slave.polygon_area) visit(triangle);
  }
}

/// Calls visit(point) for the points of a triangle that the slave's map reaches.
template <typename Visit>
void for_each_point(const SlaveFace& slave, const Triangle& triangle, int degree, const Visit& visit) {
  const Point u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
  const double twice = core::cross(u, v);
  std::array<double, 2> place{0.5, 0.5};
  for (const auto& rule : core::triangle_rule(degree)) {
    const Point at = triangle[0] + rule.a * u + rule.b * v;
    const auto found = slave.projected.invert(at, place);
    if (!found) continue;
    place = *found;
    const core::FacePlace on = core::face_place(*slave.surface.nodes, slave.quad(), place[0], place[1]);
    const double stretch = on.area().norm() / on.area().dot(slave.plane.normal);
    visit(PlanePoint{at, rule.weight * twice * stretch, place, on.position});
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
  for_each_triangle(slave, slave.polygon, [&](const Triangle& triangle) {
    for_each_point(slave, triangle, degree, [&](const PlanePoint& point) { sum += point.area; });
  });
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
      const ProjectedFace projected(slave.plane, *surface.nodes, quad);
      Opposite opposite{static_cast<Index>(m), face, projected, turned_pieces(projected)};
      for (const Polygon& piece : opposite.pieces) {
        Polygon segment = clip(slave.polygon, piece);
        if (segment.size() > 2 && area(segment) >= least_segment * slave.polygon_area)
          opposite.segments.push_back(std::move(segment));
      }
      if (opposite.segments.empty()) continue;
      found.push_back(std::move(opposite));
    }
  }
  return found;
}

/// Whether another face is nearer at a point; of equal ones the first counts.
bool is_hidden(const SlaveFace& slave, const PlanePoint& point, const std::vector<SolidMaster>& masters,
               const std::vector<Opposite>& opposites, std::size_t own, double distance) {
  for (std::size_t k = 0; k < opposites.size(); ++k) {
    const auto& pieces = opposites[k].pieces;
    const auto covers = [&](const Polygon& piece) { return holds(piece, point.at); };
    if (k == own || std::none_of(pieces.begin(), pieces.end(), covers)) continue;
    const auto other = facing(slave, point, masters[opposites[k].master].surface, opposites[k]);
    if (!other) continue;
    const double nearer = std::abs(other->distance) - std::abs(distance);
    if (nearer < 0 || (nearer == 0 && k < own)) return true;
  }
  return false;
}

/// Makes the points between a slave face and one of its opposites.
class SegmentPoints {
 public:
  SegmentPoints(const SlaveFace& slave, const std::vector<SolidMaster>& masters, const std::vector<Opposite>& opposites,
                const SolidMortarOptions& options)
      : slave_(slave), masters_(masters), opposites_(opposites), options_(options) {
    double covered = 0;
    for (const Opposite& opposite : opposites)
      for (const Polygon& segment : opposite.segments) covered += area(segment);
    overlap_ = covered > (1 + 1e-6) * slave.polygon_area;
    correction_ = area_correction(slave, options.degree);
  }

  /// Appends those of one opposite in contact; false where it is out of reach.
  bool add(std::size_t opposite, Index pair, std::vector<core::SolidInterfacePoint>& points) {
    own_ = opposite;
    pair_ = pair;
    near_ = false;
    for (const Polygon& segment : opposites_[opposite].segments)
      for_each_triangle(slave_, segment, [&](const Triangle& triangle) { add_triangle(triangle, 0, points); });
    return near_;
  }

 private:
  static constexpr int most_splits = 2;
  static constexpr double most_change = 0.2;  ///< of the contact weight within a triangle that is not split

  /// Where the weight changes the triangle is split into four.
  void add_triangle(const Triangle& triangle, int splits, std::vector<core::SolidInterfacePoint>& points) {
    const std::size_t first = points.size();
    double least = 1, most = 0;
    for_each_point(slave_, triangle, splits == 0 ? options_.degree : 2, [&](const PlanePoint& at) {
      const double weight = add_point(at, points);
      least = std::min(least, weight);
      most = std::max(most, weight);
    });
    if (splits == most_splits || most - least <= most_change) return;
    points.resize(first);
    const auto middle = [&](int i, int j) -> Point { return 0.5 * (triangle[i] + triangle[j]); };
    const Point a = middle(0, 1), b = middle(1, 2), c = middle(2, 0);
    for (const Triangle& part : {Triangle{triangle[0], a, c}, {a, triangle[1], b}, {c, b, triangle[2]}, {a, b, c}})
      add_triangle(part, splits + 1, points);
  }

  /// Returns the contact weight.
  double add_point(const PlanePoint& at, std::vector<core::SolidInterfacePoint>& points) {
    const SolidMaster& master = masters_[opposites_[own_].master];
    const auto on = facing(slave_, at, master.surface, opposites_[own_]);
    if (!on || !(std::abs(on->distance) <= options_.reach)) return 0;
    near_ = true;
    const ContactState state = master.contact ? master.contact(slave_.face, at.place) : ContactState{on->distance, 0};
    const double weight = contact_weight(state.gap, master.transition_gap);
    if (!(weight > 0)) return 0;
    if (overlap_ && is_hidden(slave_, at, masters_, opposites_, own_, on->distance)) return 0;
    points.push_back({pair_, core::quad_shape(at.place[0], at.place[1]), core::quad_shape(on->place[0], on->place[1]),
                      at.place, at.position, correction_ * at.area, state.gap, weight, state.pressure, master.law,
                      state.opening, state.closing_rate});
    return weight;
  }

  const SlaveFace& slave_;
  const std::vector<SolidMaster>& masters_;
  const std::vector<Opposite>& opposites_;
  const SolidMortarOptions& options_;
  double correction_ = 1;
  bool overlap_ = false, near_ = false;
  std::size_t own_ = 0;
  Index pair_ = 0;
};

/// All pairs and points of one slave face.
void add_slave_face(const SlaveFace& slave, const Opponents& opponents, const SolidMortarOptions& options,
                    core::SolidInterface& interface) {
  const std::vector<Opposite> opposites = opposites_of(slave, opponents, options.reach);
  if (opposites.empty()) return;
  SegmentPoints segment(slave, opponents.masters, opposites, options);
  for (std::size_t k = 0; k < opposites.size(); ++k) {
    const auto pair = static_cast<Index>(interface.pairs.size());
    if (!segment.add(k, pair, interface.points)) continue;
    const SolidSurface& master = opponents.masters[opposites[k].master].surface;
    interface.pairs.push_back({slave.surface.body, slave.face, master.body, opposites[k].face});
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
