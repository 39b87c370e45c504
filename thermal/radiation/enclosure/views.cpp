// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/views.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parison::thermal {

namespace {

constexpr int most_scalings = 50;        ///< of the rows
constexpr double outline_share = 2;      ///< rays of a piece of an outline around all edges, over those of a patch
constexpr double outline_margin = 1e-3;  ///< between all edges and an outline around them, of their size

double size_of(const std::vector<ViewEdge>& edges) {
  Point low = edges.front().points[0], high = low;
  for (const ViewEdge& edge : edges)
    for (const Point& x : edge.points) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  return (high - low).norm();
}

double length_of(const ViewEdge& edge) {
  return (edge.points[1] - edge.points[0]).norm();
}

/// How often the outlines wind around a point: minus one for each body that it is in. Counted along a line from there
/// upwards along a coordinate, or downwards.
int winding(const std::vector<ViewEdge>& edges, const Point& x, int coordinate, double sense) {
  const int other = 1 - coordinate;
  int count = 0;
  const auto count_crossing = [&](const Point& a, const Point& b) {
    if ((a[other] > x[other]) == (b[other] > x[other])) return;
    const double at = a[coordinate] + (x[other] - a[other]) / (b[other] - a[other]) * (b[coordinate] - a[coordinate]);
    if (sense * (at - x[coordinate]) > 0) count += (b[other] > a[other]) == ((coordinate == 0) == (sense > 0)) ? 1 : -1;
  };
  for (const ViewEdge& edge : edges) {
    count_crossing(edge.points[0], edge.points[2]);
    count_crossing(edge.points[2], edge.points[1]);
  }
  return count;
}

/// Whether a point of an edge has air before it. Lines that disagree about it have met an open outline.
bool is_in_air(const std::vector<ViewEdge>& edges, Index e, Point x) {
  constexpr double aside = 1e-3;  // of the edge
  const Point along = edges[e].points[1] - edges[e].points[0];
  x += aside * Point(-along[1], along[0]);
  return winding(edges, x, 0, 1) >= 0 || winding(edges, x, 1, 1) >= 0 || winding(edges, x, 1, -1) >= 0;
}

/// Corners of the convex hull, anticlockwise (A. M. Andrew, Inf. Process. Lett. 9 (1979) 216-219).
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return std::pair(a[0], a[1]) < std::pair(b[0], b[1]); });
  std::vector<Point> hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto x = begin; x != end; ++x) {
      while (hull.size() > first + 1 && core::cross(hull.back() - hull[hull.size() - 2], *x - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*x);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

/// A convex outline a little outside of all edges, the air on its left, in pieces of a length at most, each a patch of
/// its own: what leaves through it goes to the surroundings.
std::vector<ViewEdge> outline_around(const std::vector<ViewEdge>& edges, Geometry geometry, double piece,
                                     Index first_patch) {
  const bool is_round = geometry == Geometry::axisymmetric;
  const double margin = outline_margin * size_of(edges);
  std::vector<Point> points;
  for (const ViewEdge& edge : edges)
    for (const Point& x : edge.points)
      for (const double dr : {-margin, margin})
        for (const double dz : {-margin, margin}) {
          points.emplace_back(x[0] + dr, x[1] + dz);
          if (is_round) points.emplace_back(-x[0] + dr, x[1] + dz);
        }
  const std::vector<Point> hull = convex_hull(std::move(points));
  std::vector<ViewEdge> outline;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    Point a = hull[i], b = hull[(i + 1) % hull.size()];
    if (is_round && std::max(a[0], b[0]) <= 0) continue;
    if (is_round && a[0] < 0) a += a[0] / (a[0] - b[0]) * (b - a), a[0] = 0;
    if (is_round && b[0] < 0) b += b[0] / (b[0] - a[0]) * (a - b), b[0] = 0;
    const auto count = static_cast<int>(std::ceil((b - a).norm() / piece));
    for (int k = 0; k < count; ++k) {
      const auto at = [&](double share) -> Point { return a + share / count * (b - a); };
      outline.push_back({{at(k), at(k + 1), at(k + 0.5)},
                         first_patch++,
                         (b - a).norm() / count * core::depth(geometry, at(k + 0.5))});
    }
  }
  return outline;
}

/// Counts where the light of the edges arrives.
class ViewTracer {
 public:
  /// `edges` are those of the surface, with `patches` patches, and of an outline around them all.
  ViewTracer(const std::vector<ViewEdge>& surface, const std::vector<ViewEdge>& edges, Geometry geometry, Index patches,
             Index with_outline, RayPart part)
      : surface_(surface),
        edges_(edges),
        geometry_(geometry),
        part_(part),
        section_(points_of(edges), size_of(edges), geometry, true),
        in_air_(edges.size()),
        patches_(patches),
        arrived_(Eigen::MatrixXd::Zero(with_outline, with_outline)),
        slipped_(Eigen::VectorXd::Zero(with_outline)),
        lost_(Eigen::VectorXd::Zero(with_outline)),
        rays_(Eigen::ArrayXd::Zero(with_outline)),
        area_(Eigen::ArrayXd::Zero(with_outline)) {}

  /// Sends `count` rays from an edge, evenly along it and with the cosine law.
  void send(Index e, int count) {
    if (section_.facet_at(e, 0) < 0) return;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += depth_at(e, (i + 0.5) / count);
    rays_[edges_[e].patch] += count;
    area_[edges_[e].patch] += edges_[e].area;
    for (int i = 0; i < count; ++i, ++sent_) {
      const double s = (i + 0.5) / count;
      const auto [square, turn] = spread_place(sent_);
      if (const int weight = part_.weight(sent_); weight > 0)
        follow(e, s, std::sqrt(square), M_PI * turn, weight * edges_[e].area * depth_at(e, s) / sum);
    }
  }
  /// Whether something lies so close before an edge that nothing goes past it.
  bool is_shut(Index e, double distance) const {
    const Index facet = section_.facet_at(e, 0);
    if (facet < 0) return true;
    for (const double s : {0.1, 0.5, 0.9}) {
      const Eigen::Vector3d x = section_.point(e, s);
      const auto hit = section_.leave({x, -section_.facet_normal(section_.facet_at(e, s), x)}, section_.facet_at(e, s));
      if (!hit || hit->distance > distance) return false;
    }
    return true;
  }

  /// What one of two patches says of both counts by the rays that it sent from each square metre.
  Views result() const {
    const Eigen::ArrayXd density = (area_ > 0).select(rays_ / area_, 0.0);
    const auto weight = [&](Index i, Index j) {
      return density[i] + density[j] > 0 ? density[i] / (density[i] + density[j]) : 0;
    };
    Views views{Eigen::MatrixXd(patches_, patches_), slipped_.head(patches_), lost_.head(patches_)};
    for (Index i = 0; i < patches_; ++i) {
      for (Index j = 0; j < patches_; ++j)
        views.between(i, j) = weight(i, j) * arrived_(i, j) + weight(j, i) * arrived_(j, i);
      for (Index j = patches_; j < arrived_.rows(); ++j)
        views.open[i] += weight(i, j) * arrived_(i, j) + weight(j, i) * arrived_(j, i);
    }
    views.between = (0.5 * (views.between + views.between.transpose())).eval();  // to the last bit
    return views;
  }

 private:
  static std::vector<SectionEdge> points_of(const std::vector<ViewEdge>& edges) {
    std::vector<SectionEdge> points;
    points.reserve(edges.size());
    for (const ViewEdge& edge : edges) points.push_back(edge.points);
    return points;
  }
  double depth_at(Index e, double s) const { return core::depth(geometry_, {section_.point(e, s)[0], 0}); }

  void follow(Index e, double s, double mu, double azimuth, double area) {
    const Index facet = section_.facet_at(e, s);
    const Eigen::Vector3d x = section_.point(e, s), outward = section_.facet_normal(facet, x);
    const Eigen::Vector3d across(0, 1, 0), along(-outward[2], 0, outward[0]);
    const double cosine = std::max(mu, grazing), sine = std::sqrt(1 - cosine * cosine);
    const Ray ray{x, -cosine * outward + sine * (std::cos(azimuth) * along + std::sin(azimuth) * across)};
    const auto hit = section_.leave(ray, facet);
    const Index from = edges_[e].patch;
    if (!hit || (!hit->from_behind && edges_[hit->edge].patch < 0))
      slipped_[from] += area;
    else if (hit->from_behind)
      lost_[from] += is_lost(e, s, hit->distance) ? area : 0;
    else
      arrived_(from, edges_[hit->edge].patch) += area;
  }

  /// Of a ray that has ended behind a surface. Where bodies touch some end so within the length of an edge.
  bool is_lost(Index e, double s, double distance) {
    if (e >= static_cast<Index>(surface_.size()) || distance < length_of(edges_[e])) return false;
    if (!in_air_[e]) in_air_[e] = is_in_air(surface_, e, edges_[e].points[2]);
    const Eigen::Vector3d x = section_.point(e, s);
    return *in_air_[e] && is_in_air(surface_, e, {x[0], x[2]});
  }

  const std::vector<ViewEdge>& surface_;
  const std::vector<ViewEdge>& edges_;
  Geometry geometry_;
  RayPart part_;
  Section section_;
  std::vector<std::optional<bool>> in_air_;  ///< before the middle of each edge, where it was asked for
  Index patches_;
  Eigen::MatrixXd arrived_;         ///< from a patch at another, m2
  Eigen::VectorXd slipped_, lost_;  ///< past all edges, behind one, m2
  Eigen::ArrayXd rays_, area_;      ///< sent from each patch
  long sent_ = 0;
};

}  // namespace

Views trace_views(const std::vector<ViewEdge>& surface, Geometry geometry, Index patches, int rays, RayPart part) {
  if (patches == 0) return {};
  std::vector<ViewEdge> edges = surface;
  const auto sends = [&](std::size_t e) { return edges[e].patch >= 0 && edges[e].area > 0; };
  double piece = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) piece += sends(e) ? length_of(edges[e]) / patches : 0;
  std::vector<ViewEdge> outline = outline_around(surface, geometry, piece, patches);
  // An image behind a plane of symmetry sends nothing itself; the outline sends to all images.
  double all = 0, originals = 0;
  for (std::size_t e = 0; e < surface.size(); ++e) all += surface[e].patch >= 0 ? 1 : 0, originals += sends(e) ? 1 : 0;
  for (ViewEdge& edge : outline) edge.area *= originals / all;
  edges.insert(edges.end(), outline.begin(), outline.end());
  const Index with_outline = patches + static_cast<Index>(outline.size());
  ViewTracer tracer(surface, edges, geometry, patches, with_outline, part);
  Eigen::ArrayXd length = Eigen::ArrayXd::Zero(with_outline);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (sends(e)) length[edges[e].patch] += length_of(edges[e]);
  const double close = 2 * outline_margin * size_of(surface);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const bool outside = e >= surface.size();
    if (!sends(e) || (outside && tracer.is_shut(static_cast<Index>(e), close))) continue;
    const double count = (outside ? outline_share : 1) * rays * length_of(edges[e]) / length[edges[e].patch];
    tracer.send(static_cast<Index>(e), std::max(2, static_cast<int>(std::lround(count))));
  }
  return tracer.result();
}

Views closed(Views views, const Eigen::ArrayXd& area) {
  constexpr double close_enough = 1e-10;
  for (int k = 0; k < most_scalings; ++k) {
    const Eigen::ArrayXd sum = views.between.rowwise().sum().array() + views.open.array();
    if (!((sum - area).abs() > close_enough * area).any()) break;
    const Eigen::ArrayXd factor = (sum > 0).select((area / sum).sqrt(), 0.0);
    views.between = (factor.matrix().asDiagonal() * views.between * factor.matrix().asDiagonal()).eval();
    // The surroundings' own factor is 1, so that theirs is made good in the end.
    views.open.array() *= factor;
  }
  const Eigen::ArrayXd sum = views.between.rowwise().sum().array() + views.open.array();
  const Eigen::ArrayXd share = (sum > area).select(area / sum, 1.0);
  for (Eigen::Index i = 0; i < area.size(); ++i)
    for (Eigen::Index j = 0; j < area.size(); ++j) views.between(i, j) *= std::min(share[i], share[j]);
  views.open.array() *= share;
  views.between = (0.5 * (views.between + views.between.transpose())).eval();  // to the last bit
  views.between.diagonal().array() += area - views.between.rowwise().sum().array() - views.open.array();
  return views;
}

}  // namespace parison::thermal
