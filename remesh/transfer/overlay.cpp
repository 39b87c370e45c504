// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/transfer/overlay.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/cell_map.hpp"
#include "core/mesh/element.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double inside = 1e-10;  ///< slack of the reference coordinates

/// Nearest point of the reference triangle, near enough for points that are hardly outside.
std::array<double, 2> clamp_to_cell(const std::array<double, 2>& at) {
  const std::array<double, 3> fraction{std::max(0.0, 1 - at[0] - at[1]), std::max(0.0, at[0]), std::max(0.0, at[1])};
  const double sum = fraction[0] + fraction[1] + fraction[2];
  return {fraction[1] / sum, fraction[2] / sum};
}

}  // namespace

namespace {

core::UniformGrid grid_over(const Mesh& mesh) {
  const core::Box box = core::bounding_box(mesh.nodes);
  const Point extent = box.high - box.low;
  return {box, std::max(std::sqrt(extent.prod() / mesh.cell_count()), extent.maxCoeff() / 1000)};
}

std::vector<core::Box> cell_boxes(const Mesh& mesh) {
  std::vector<core::Box> boxes;
  boxes.reserve(mesh.cells().size());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) boxes.push_back(cell_box(mesh, cell));
  return boxes;
}

}  // namespace

core::Box cell_box(const Mesh& mesh, Index cell) {
  return core::bounding_box(mesh, mesh.cells()[cell], 0.1);
}

CellGrid::CellGrid(const Mesh& mesh) : mesh_(mesh), cells_(grid_over(mesh), cell_boxes(mesh)) {}

CellGrid::Found CellGrid::find(const Point& x) const {
  const core::UniformGrid& grid = cells_.grid();
  const core::UniformGrid::Bin centre = grid.bin_at(x);
  Found best;
  for (const Index cell : cells_.boxes_in(centre))
    if (cells_.box(cell).meets({x, x}) && try_cell(cell, x, best)) return best;
  for (int ring = 0; ring <= std::max(grid.count()[0], grid.count()[1]); ++ring) {
    if (try_ring(centre, ring, x, best)) return best;
    if (best.cell >= 0 && best.miss <= ring * grid.bin_size()) break;
  }
  return best;
}

/// Tries the cells in the bins `ring` columns or rows away from one; true when one contains the point.
bool CellGrid::try_ring(const core::UniformGrid::Bin& centre, int ring, const Point& x, Found& best) const {
  const core::UniformGrid& grid = cells_.grid();
  for (int row = std::max(0, centre[1] - ring); row <= std::min(grid.count()[1] - 1, centre[1] + ring); ++row)
    for (int column = std::max(0, centre[0] - ring); column <= std::min(grid.count()[0] - 1, centre[0] + ring);
         ++column) {
      if (std::max(std::abs(column - centre[0]), std::abs(row - centre[1])) < ring) continue;
      for (const Index cell : cells_.boxes_in({column, row}))
        if (try_cell(cell, x, best)) return true;
    }
  return false;
}

/// Keeps the cell when it is nearer than the best so far; true when it contains the point.
bool CellGrid::try_cell(Index cell, const Point& x, Found& best) const {
  const core::Box& box = cells_.box(cell);
  if ((x - x.cwiseMax(box.low).cwiseMin(box.high)).norm() >= best.miss) return false;
  const auto at = core::invert_cell_map(mesh_, cell, x);
  if (!std::isfinite(at[0] + at[1])) return false;
  const auto clamped = clamp_to_cell(at);
  if (std::min({at[0], at[1], 1 - at[0] - at[1]}) > -inside) {
    best = {cell, clamped, 0};
    return true;
  }
  const auto shape = core::triangle_shape(clamped[0], clamped[1]);
  Point reached = Point::Zero();
  for (int k = 0; k < 6; ++k) reached += shape[k] * mesh_.nodes[mesh_.cells()[cell][k]];
  const double miss = (reached - x).norm();
  if (miss < best.miss) best = {cell, clamped, miss};
  return false;
}

namespace {

constexpr double straight = 1e-9;     ///< mid-side offset over size below which a cell counts as straight
constexpr double negligible = 1e-12;  ///< share of a cell
constexpr double furthest = 0.3;      ///< extrapolation out of an old cell, reference coordinates

/// Reference coordinates, those of a point farther outside than `furthest` brought back to there. Small changes of the
/// point change the result a little only.
std::array<double, 2> limited(const std::array<double, 2>& at) {
  std::array<double, 3> above{1 - at[0] - at[1], at[0], at[1]};
  double sum = 0;
  for (double& fraction : above) sum += fraction = std::max(0.0, fraction + furthest);
  const double scale = (1 + 3 * furthest) / sum;
  return {above[1] * scale - furthest, above[2] * scale - furthest};
}

/// Convex polygon of a few corners.
struct Polygon {
  std::array<Point, 10> corner;
  int count = 0;
  void add(const Point& x) { corner[count++] = x; }
};

/// The part on the left of the line a to b.
Polygon clip(const Polygon& polygon, const Point& a, const Point& b) {
  Polygon kept;
  for (int i = 0; i < polygon.count; ++i) {
    const Point &p = polygon.corner[i], &q = polygon.corner[(i + 1) % polygon.count];
    const double at_p = core::cross(b - a, p - a), at_q = core::cross(b - a, q - a);
    if (at_p >= 0) kept.add(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.add(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

bool is_straight(const core::CellMap& map) {
  return std::all_of(map.mid_side_offset.begin(), map.mid_side_offset.end(),
                     [&](const Point& offset) { return offset.norm() <= straight * map.u.norm(); });
}

/// A convex region in which an old cell's field is used.
struct Region {
  Polygon polygon;
  Index cell;
  core::Box box;
};

core::Box box_of(const Polygon& polygon) {
  core::Box box{polygon.corner[0], polygon.corner[0]};
  for (int i = 1; i < polygon.count; ++i) {
    box.low = box.low.cwiseMin(polygon.corner[i]);
    box.high = box.high.cwiseMax(polygon.corner[i]);
  }
  return box;
}

/// Strips outside the boundary, each with the field of the cell at its edge.
std::vector<std::vector<Region>> outer_regions(const Mesh& mesh) {
  std::vector<Point> outward(mesh.nodes.size(), Point::Zero());
  std::vector<double> reach(mesh.nodes.size(), 0);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const Point chord = mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]];
    for (int k = 0; k < 2; ++k) {
      outward[edge.nodes[k]] += Point(chord[1], -chord[0]).normalized();
      reach[edge.nodes[k]] = std::max(reach[edge.nodes[k]], 0.2 * chord.norm());
    }
  }
  std::vector<std::vector<Region>> regions(mesh.cells().size());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    Polygon strip;
    const auto [a, b, mid] = edge.nodes;
    strip.add(mesh.nodes[a]);
    strip.add(mesh.nodes[a] + reach[a] * outward[a].normalized());
    strip.add(mesh.nodes[b] + reach[b] * outward[b].normalized());
    strip.add(mesh.nodes[b]);
    regions[edge.cell].push_back({strip, edge.cell, box_of(strip)});
  }
  return regions;
}

/// Adds up the load of one new cell part by part.
class Overlay {
 public:
  Overlay(const Mesh& from, const Mesh& to, core::Geometry geometry, const Eigen::VectorXd& nodal,
          const Eigen::VectorXd& subtracted)
      : from_(from),
        to_(to),
        geometry_(geometry),
        nodal_(nodal),
        subtracted_(subtracted),
        grid_(from),
        outer_(outer_regions(from)) {
    for (Index cell = 0; cell < from.cell_count(); ++cell) old_maps_.push_back(core::cell_map(from, cell));
  }

  std::array<double, 6> load(Index cell) {
    map_ = core::cell_map(to_, cell);
    straight_ = is_straight(map_);
    Polygon triangle;
    for (int k = 0; k < 3; ++k) triangle.add(to_.nodes[to_.cells()[cell][k]]);
    const double whole = core::cross(triangle.corner[1] - triangle.corner[0], triangle.corner[2] - triangle.corner[0]);
    std::array<double, 6> sum{};
    const core::Box box = box_of(triangle);
    const Point margin = Point::Constant(0.05 * (box.high - box.low).maxCoeff());
    grid_.near({box.low - margin, box.high + margin}, near_);
    for (const Index old : near_) {
      Polygon common = triangle;
      for (int k = 0; k < 3 && common.count > 2; ++k)
        common = clip(common, from_.nodes[from_.cells()[old][k]], from_.nodes[from_.cells()[old][(k + 1) % 3]]);
      add_polygon(cell, old, common, whole, sum);
      for (const Region& strip : outer_[old]) {
        if (!strip.box.meets(box)) continue;
        common = triangle;
        for (int k = 0; k < 4 && common.count > 2; ++k)
          common = clip(common, strip.polygon.corner[k], strip.polygon.corner[(k + 1) % 4]);
        add_polygon(cell, old, common, whole, sum);
      }
    }
    return sum;
  }

 private:
  /// Value of the field at x by the old cell. Where that is too far, by the cell that contains x or, outside all cells,
  /// by no more than the allowed extrapolation.
  double old_value(Index old, std::array<double, 2> at, const Point& x) const {
    if (!(std::min({at[0], at[1], 1 - at[0] - at[1]}) > -furthest)) {
      const CellGrid::Found found = grid_.find(x);
      if (found.miss == 0 || !std::isfinite(at[0] + at[1])) {
        old = found.cell;
        at = found.at;
      } else {
        at = limited(at);
      }
    }
    const auto shape = core::triangle_shape(at[0], at[1]);
    double value = 0;
    for (int k = 0; k < 6; ++k) value += shape[k] * nodal_[from_.cells()[old][k]];
    return value;
  }

  /// Fans the polygon, which lies in the chord triangle of the new cell, and integrates over its image in the cell.
  void add_polygon(Index cell, Index old, const Polygon& polygon, double whole, std::array<double, 6>& sum) {
    points_.clear();
    for (int i = 1; i + 1 < polygon.count; ++i) {
      const Point &o = polygon.corner[0], u = polygon.corner[i] - o, v = polygon.corner[i + 1] - o;
      const double fraction = core::cross(u, v) / whole;
      if (fraction < negligible) continue;
      for (const core::TriangleRulePoint& at : core::triangle_rule(straight_ ? 5 : 6)) {
        const Point x = o + at.a * u + at.b * v;
        const auto [a, b] = core::chord_coordinates(map_, x);
        if (straight_) {
          points_.push_back({x, at.weight * core::cross(u, v) * core::depth(geometry_, x), core::triangle_shape(a, b)});
        } else {
          const core::CellPoint point = core::map_cell_point(to_, cell, geometry_, {a, b, at.weight * fraction});
          points_.push_back({point.position, point.volume, point.shape});
        }
      }
    }
    add_points(cell, old, sum);
  }

  void add_points(Index cell, Index old, std::array<double, 6>& sum) const {
    constexpr int width = core::point_batches * core::batch_size;
    const int count = static_cast<int>(points_.size());
    for (int first = 0; first < count; first += width) {
      core::PointBatches x, reference;
      for (int i = 0; i < width; ++i)  // the last again where there are no more
        for (int d = 0; d < core::dim; ++d)
          x[i / core::batch_size][d][i % core::batch_size] = points_[std::min(first + i, count - 1)].position[d];
      core::invert(old_maps_[old], x, reference);
      for (int i = 0; i < std::min(width, count - first); ++i) {
        const IntegrationPoint& at = points_[first + i];
        const auto& [a, b] = reference[i / core::batch_size];
        const int lane = i % core::batch_size;
        double difference = old_value(old, {a[lane], b[lane]}, at.position);
        for (int k = 0; k < 6; ++k) difference -= at.shape[k] * subtracted_[to_.cells()[cell][k]];
        const double value = at.volume * difference;
        for (int k = 0; k < 6; ++k) sum[k] += at.shape[k] * value;
      }
    }
  }

  struct IntegrationPoint {
    Point position;
    double volume;
    std::array<double, 6> shape;  ///< of the new cell
  };

  const Mesh &from_, &to_;
  core::Geometry geometry_;
  const Eigen::VectorXd &nodal_, &subtracted_;
  CellGrid grid_;
  std::vector<std::vector<Region>> outer_;
  std::vector<core::CellMap> old_maps_;
  core::CellMap map_;      ///< of the new cell
  bool straight_ = false;  ///< the new cell
  std::vector<Index> near_;
  std::vector<IntegrationPoint> points_;  ///< of one polygon
};

}  // namespace

Eigen::VectorXd overlay_load(const Mesh& from, const Mesh& to, core::Geometry geometry, const Eigen::VectorXd& nodal,
                             const Eigen::VectorXd& near) {
  Overlay overlay(from, to, geometry, nodal, near);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(to.node_count());
  for (Index cell = 0; cell < to.cell_count(); ++cell) {
    const std::array<double, 6> own = overlay.load(cell);
    for (int k = 0; k < 6; ++k) load[to.cells()[cell][k]] += own[k];
  }
  return load;
}

}  // namespace parison::remesh
