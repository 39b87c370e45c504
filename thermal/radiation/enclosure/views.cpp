// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/enclosure/views.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace parison::thermal {

namespace {

constexpr double grazing = 1e-4;   ///< smallest cosine to the facet with which a ray starts
constexpr int most_scalings = 50;  ///< of the rows

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
  const auto cross = [&](const Point& a, const Point& b) {
    if ((a[other] > x[other]) == (b[other] > x[other])) return;
    const double at = a[coordinate] + (x[other] - a[other]) / (b[other] - a[other]) * (b[coordinate] - a[coordinate]);
    if (sense * (at - x[coordinate]) > 0) count += (b[other] > a[other]) == ((coordinate == 0) == (sense > 0)) ? 1 : -1;
  };
  for (const ViewEdge& edge : edges) {
    cross(edge.points[0], edge.points[2]);
    cross(edge.points[2], edge.points[1]);
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

/// Counts where the light of the edges arrives.
class ViewTracer {
 public:
  ViewTracer(const std::vector<ViewEdge>& edges, Geometry geometry, Index patches)
      : edges_(edges),
        geometry_(geometry),
        section_(points_of(edges), size_of(edges), geometry, true),
        in_air_(edges.size()),
        views_{Eigen::MatrixXd::Zero(patches, patches), Eigen::VectorXd::Zero(patches),
               Eigen::VectorXd::Zero(patches)} {}

  /// Sends `count` rays from an edge, evenly along it and with the cosine law.
  void send(Index e, int count) {
    // The R2 sequence of M. Roberts: multiples of the powers of the inverse plastic number.
    constexpr double first = 0.7548776662466927, second = 0.5698402909980532;
    if (section_.facet_at(e, 0) < 0) return;
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += depth_at(e, (i + 0.5) / count);
    for (int i = 0; i < count; ++i, ++sent_) {
      const double s = (i + 0.5) / count, square = std::fmod(0.5 + static_cast<double>(sent_) * first, 1.0);
      const double azimuth = M_PI * std::fmod(0.5 + static_cast<double>(sent_) * second, 1.0);
      follow(e, s, std::sqrt(square), azimuth, edges_[e].area * depth_at(e, s) / sum);
    }
  }
  Views result() {
    views_.between = (0.5 * (views_.between + views_.between.transpose())).eval();
    return std::move(views_);
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
      views_.open[from] += area;
    else if (hit->from_behind)
      views_.lost[from] += is_lost(e, s, hit->distance) ? area : 0;
    else
      views_.between(from, edges_[hit->edge].patch) += area;
  }

  /// Of a ray that has ended behind a surface. Where bodies touch some end so within the length of an edge.
  bool is_lost(Index e, double s, double distance) {
    if (distance < length_of(edges_[e])) return false;
    if (!in_air_[e]) in_air_[e] = is_in_air(edges_, e, edges_[e].points[2]);
    const Eigen::Vector3d x = section_.point(e, s);
    return *in_air_[e] && is_in_air(edges_, e, {x[0], x[2]});
  }

  const std::vector<ViewEdge>& edges_;
  Geometry geometry_;
  Section section_;
  std::vector<std::optional<bool>> in_air_;  ///< before the middle of each edge, where it was asked for
  Views views_;
  long sent_ = 0;
};

}  // namespace

Views trace_views(const std::vector<ViewEdge>& edges, Geometry geometry, Index patches, int rays) {
  if (patches == 0) return {};
  ViewTracer tracer(edges, geometry, patches);
  Eigen::ArrayXd length = Eigen::ArrayXd::Zero(patches);
  for (const ViewEdge& edge : edges)
    if (edge.patch >= 0 && edge.area > 0) length[edge.patch] += length_of(edge);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const ViewEdge& edge = edges[e];
    if (edge.patch < 0 || !(edge.area > 0)) continue;
    tracer.send(static_cast<Index>(e),
                std::max(2, static_cast<int>(std::lround(rays * length_of(edge) / length[edge.patch]))));
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
