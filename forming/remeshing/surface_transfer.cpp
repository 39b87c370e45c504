// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/surface_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/element.hpp"
#include "remesh/transfer/mass_matrix.hpp"

namespace parison::forming {

namespace {

/// Each new edge is integrated in this many parts with this many points each, as old nodes lie within it.
constexpr int parts = 4, points_of_part = 3;

std::vector<core::BoundaryEdge> contact_edges(const core::Mesh& mesh) {
  std::vector<core::BoundaryEdge> edges;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == core::BoundaryKind::contact) edges.push_back(edge);
  return edges;
}

/// Nearest point found so far: its distance, m, its edge and where on that.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  std::size_t edge = 0;
  double s = 0;
};

/// Finds the nearest point of a surface, each half edge as the straight line between two nodes.
class NearestPoint {
 public:
  NearestPoint(const core::Mesh& mesh, const std::vector<core::BoundaryEdge>& edges) : mesh_(mesh), edges_(edges) {
    for (const core::BoundaryEdge& edge : edges) {
      const core::Point& middle = mesh.nodes[edge.nodes[2]];
      radius_.push_back(
          std::max((mesh.nodes[edge.nodes[0]] - middle).norm(), (mesh.nodes[edge.nodes[1]] - middle).norm()));
    }
  }

  /// The search starts at an edge that may be near.
  Nearest operator()(const core::Point& x, std::size_t start) const {
    Nearest nearest;
    consider(start, x, nearest);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const double reach = nearest.distance + radius_[e];
      if ((mesh_.nodes[edges_[e].nodes[2]] - x).squaredNorm() < reach * reach) consider(e, x, nearest);
    }
    return nearest;
  }

 private:
  void consider(std::size_t edge, const core::Point& x, Nearest& nearest) const {
    const auto [first, last, middle] = edges_[edge].nodes;
    consider_half(edge, mesh_.nodes[first], mesh_.nodes[middle], 0, x, nearest);
    consider_half(edge, mesh_.nodes[middle], mesh_.nodes[last], 0.5, x, nearest);
  }
  static void consider_half(std::size_t edge, const core::Point& first, const core::Point& last, double begin,
                            const core::Point& x, Nearest& nearest) {
    const core::Point along = last - first, from = x - first;
    const double length = along.squaredNorm();
    const double s = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
    const double distance = (from - s * along).norm();
    if (distance < nearest.distance) nearest = {distance, edge, begin + 0.5 * s};
  }

  const core::Mesh& mesh_;
  const std::vector<core::BoundaryEdge>& edges_;
  std::vector<double> radius_;
};

/// Along an edge, within the range of its nodes, as a pressure that is zero at one node is nowhere negative.
double value_at(const core::BoundaryEdge& edge, const std::array<double, 3>& shape, const Eigen::VectorXd& field) {
  double value = 0, low = field[edge.nodes[0]], high = low;
  for (int i = 0; i < 3; ++i) {
    const double nodal = field[edge.nodes[i]];
    value += shape[i] * nodal;
    low = std::min(low, nodal);
    high = std::max(high, nodal);
  }
  return std::clamp(value, low, high);
}

/// The projection within bounds: values beyond theirs are put there and the others found anew, until all are inside.
Eigen::VectorXd solve_within(const remesh::MassMatrix& mass, const Eigen::VectorXd& load, const Eigen::VectorXd& low,
                             const Eigen::VectorXd& high) {
  constexpr int most = 10;
  Eigen::VectorXd found = 0.5 * (low + high);
  std::vector<bool> at_bound(static_cast<std::size_t>(load.size()), false);
  for (int i = 0; i < most; ++i) {
    const Eigen::VectorXd free = mass.solve(load, found, at_bound);
    found = free.cwiseMax(low).cwiseMin(high);
    if (found == free) break;
    for (core::Index n = 0; n < found.size(); ++n)
      if (found[n] != free[n]) at_bound[n] = true;
  }
  return found;
}

/// Moves every value by the same share of its distance to its bound, such that the field has a wanted integral.
template <typename Integral>
void restore_integral(const Integral& integral, double wanted, const Eigen::VectorXd& low, const Eigen::VectorXd& high,
                      Eigen::VectorXd& field) {
  constexpr double kept = 1e-12;
  constexpr int most = 5;
  for (int i = 0; i < most; ++i) {
    const double now = integral(field), missing = wanted - now;
    if (std::abs(missing) <= kept * std::abs(wanted)) return;
    const Eigen::VectorXd& bound = missing > 0 ? high : low;
    const double room = integral(bound) - now;
    if (!(missing / room > 0)) return;
    field += std::min(missing / room, 1.0) * (bound - field);
  }
}

}  // namespace

SurfaceTransfer::SurfaceTransfer(const core::Mesh& old, const core::Mesh& mesh, core::Geometry geometry)
    : mesh_(mesh), geometry_(geometry), old_edges_(contact_edges(old)), edges_(contact_edges(mesh)) {
  if (old_edges_.empty()) return;
  const NearestPoint nearest_point(old, old_edges_);
  std::size_t start = 0;
  const auto sample = [&](std::size_t e, const core::EdgeRulePoint& at) {
    const core::EdgePoint point = core::map_edge_point(mesh_, edges_[e].nodes, geometry_, at);
    const Nearest nearest = nearest_point(point.position, start);
    start = nearest.edge;
    samples_.push_back({e, nearest.edge, nearest.s, point.shape, point.area});
  };
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for (const double s : {0.0, 0.5, 1.0}) sample(e, {s, 0});  // the nodes
    for (int part = 0; part < parts; ++part)
      for (const core::EdgeRulePoint& at : core::edge_rule(points_of_part))
        sample(e, {(part + at.s) / parts, at.weight / parts});
  }
}

Eigen::VectorXd SurfaceTransfer::interpolate(const Eigen::VectorXd& field) const {
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(mesh_.node_count());
  for (const Sample& sample : samples_)
    if (sample.area == 0)
      for (int i = 0; i < 3; ++i)
        if (sample.shape[i] == 1)
          carried[edges_[sample.edge].nodes[i]] =
              value_at(old_edges_[sample.old_edge], core::edge_shape(sample.old_s), field);
  return carried;
}

double SurfaceTransfer::integral(const Eigen::VectorXd& field) const {
  double sum = 0;
  for (const Sample& sample : samples_) sum += sample.area * value_at(edges_[sample.edge], sample.shape, field);
  return sum;
}

Eigen::VectorXd SurfaceTransfer::project(const Eigen::VectorXd& field) const {
  const core::Index size = mesh_.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size), low = load, high = load;
  std::vector<bool> seen(static_cast<std::size_t>(size), false);
  double wanted = 0;
  for (const Sample& sample : samples_) {
    const double value = value_at(old_edges_[sample.old_edge], core::edge_shape(sample.old_s), field);
    wanted += sample.area * value;
    for (int i = 0; i < 3; ++i) {
      const core::Index node = edges_[sample.edge].nodes[i];
      load[node] += sample.shape[i] * sample.area * value;
      low[node] = seen[node] ? std::min(low[node], value) : value;
      high[node] = seen[node] ? std::max(high[node], value) : value;
      seen[node] = true;
    }
  }
  const remesh::MassMatrix mass(mesh_, geometry_, edges_);
  Eigen::VectorXd found = solve_within(mass, load, low, high);
  restore_integral([&](const Eigen::VectorXd& trial) { return integral(trial); }, wanted, low, high, found);
  return found;
}

}  // namespace parison::forming
