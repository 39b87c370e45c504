// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/solid/wall_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/case/table.hpp"
#include "core/process/run_error.hpp"

namespace parison::remesh {

namespace {

using core::Vector3;

/// Place of a node in the wall laid flat: in polar coordinates the arc from the axis, m, and the angle about it; and
/// across the wall.
struct FlatPlace {
  double x, y;  ///< m
  double across;
};

constexpr int line_pieces = 2000;

/// A wall by a length, m, that grows as that of its longer side: on neither side is a cell then longer than asked for.
/// `along` of the wall's coordinates there.
class WallLine {
 public:
  explicit WallLine(const WallCoordinates& wall) {
    const auto places = [&](double along) {
      return std::array{wall.place(along, 0), wall.place(along, 0.5), wall.place(along, 1)};
    };
    auto before = places(0);
    for (int i = 0; i <= line_pieces; ++i) {
      const double along = double(i) / line_pieces;
      const auto at = places(along);
      double way = 0;
      for (std::size_t k = 0; k < at.size(); ++k) way = std::max(way, (at[k] - before[k]).norm());
      if (i > 0 && way == 0) continue;
      table_.x.push_back(i == 0 ? 0 : table_.x.back() + way);
      table_.y.push_back(along);
      widest_ = std::max(widest_, at[1][0]);
      before = at;
    }
  }
  double length() const { return table_.x.back(); }
  double widest() const { return widest_; }  ///< largest radius of its middle, m
  double along(double arc) const { return arc > length() * (1 - 1e-12) ? 1 : table_(arc); }

 private:
  core::Table table_;
  double widest_ = 0;
};

/// One side of a wall by the length of the wall, m. At knots it is where the wall's coordinates have it, between
/// them the side goes on by equal lengths.
class SideLine {
 public:
  SideLine(const WallCoordinates& wall, const WallLine& line, SurfacePart part, const std::vector<double>& knots) {
    const auto points = wall.side(part);
    core::Table arc_of;  // by `along`
    double arc = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double way = i == 0 ? 0 : (points[i].at - points[i - 1].at).norm();
      if (i > 0 && way == 0) continue;
      arc += way;
      r_.x.push_back(arc), r_.y.push_back(points[i].at[0]);
      z_.x.push_back(arc), z_.y.push_back(points[i].at[1]);
      if (i > 0 && points[i].along <= arc_of.x.back()) continue;
      arc_of.x.push_back(points[i].along), arc_of.y.push_back(arc);
    }
    arc_of.y.back() = arc;
    for (const double knot : knots) arc_.x.push_back(knot), arc_.y.push_back(arc_of(line.along(knot)));
  }
  core::Point place(double wall_arc) const {
    const double arc = arc_(wall_arc);
    return {r_(arc), z_(arc)};
  }

 private:
  core::Table r_, z_;  ///< by the length of the side
  core::Table arc_;    ///< length of the side, by that of the wall
};

/// A point of the unit square laid into a quarter disc of radius 1: more square than round, so that the corner of the
/// square is one of its border too.
std::array<double, 2> in_quarter_disc(double a, double b) {
  const double far = std::max(a, b);
  if (far == 0) return {0, 0};
  const double angle = a >= b ? M_PI_4 * b / a : M_PI_2 - M_PI_4 * a / b;
  constexpr double round = 0.3, side = 0.85;  // share of the arc; side of the square over the radius
  return {round * far * std::cos(angle) + (1 - round) * side * a,
          round * far * std::sin(angle) + (1 - round) * side * b};
}

/// The border of that disc at a share of the quarter turn.
std::array<double, 2> border_of_disc(double share) {
  return share < 0.5 ? in_quarter_disc(1, 2 * share) : in_quarter_disc(2 - 2 * share, 1);
}

/// Collects cells and joins their nodes where they share a place.
class WallBuilder {
 public:
  /// `knots`: lengths of the wall at which rings of cells end, from 0 to its whole length.
  WallBuilder(const WallCoordinates& wall, const WallLine& line, const WallDivision& division,
              const std::vector<double>& knots)
      : wall_(wall),
        line_(line),
        division_(division),
        ends_(layer_ends(division.layers)),
        inner_(wall, line, SurfacePart::inner, knots),
        outer_(wall, line, SurfacePart::outer, knots),
        last_ring_(knots[knots.size() - 2]) {}

  /// A stack of cells, one for each layer, over a part of the wall laid flat: place(u, v), u and v from 0 to 1.
  /// `at_rim`: its side u = 1 is on the rim.
  template <typename Place>
  void add_stack(const Place& place, bool at_rim) {
    for (Index layer = 0; layer < division_.layers; ++layer) {
      std::array<Index, core::HexMesh::nodes_per_cell> cell;
      for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 3; ++i) {
            const std::array<double, 2> flat = place(0.5 * i, 0.5 * j);
            const auto l = static_cast<std::size_t>(layer);
            const double across = ends_[l] + 0.5 * k * (ends_[l + 1] - ends_[l]);
            cell[static_cast<std::size_t>(i + 3 * j + 9 * k)] = node({flat[0], flat[1], across});
          }
      const Index c = result_.mesh.cell_count();
      result_.mesh.cells.push_back(cell);
      if (layer == 0) result_.inner.push_back({c, 2, 0});
      if (layer + 1 == division_.layers) result_.outer.push_back({c, 2, 1});
      if (at_rim) result_.rim.push_back({c, 0, 1});
    }
  }

  WallMesh take() {
    turn_right_handed();
    add_planes();
    for (const auto& [place, nodes] : columns_) {
      result_.columns.emplace_back();
      for (const auto& [across, node] : nodes) result_.columns.back().push_back(node);
    }
    return std::move(result_);
  }

 private:
  Index node(const FlatPlace& at) {
    constexpr double same = 1e-9;  // m, and of the wall
    const auto key =
        std::make_tuple(std::llround(at.x / same), std::llround(at.y / same), std::llround(at.across / same));
    const auto [found, is_new] = numbers_.try_emplace(key, result_.mesh.node_count());
    if (!is_new) return found->second;
    columns_[{std::get<0>(key), std::get<1>(key)}][std::get<2>(key)] = found->second;
    const double arc = std::hypot(at.x, at.y), angle = arc == 0 ? 0 : std::atan2(at.y, at.x);
    const core::Point place = through_wall(arc, at.across);
    const double radius = std::get<0>(key) == 0 && std::get<1>(key) == 0 ? 0 : place[0];
    result_.mesh.nodes.emplace_back(radius * std::cos(angle), radius * std::sin(angle), place[1]);
    return found->second;
  }

  /// A place on the line between the sides; in the ring at the rim it goes over to the rim's own line. Edges are
  /// straight there: a rim that is round bends into the sides without a corner, and cells in its corners would have
  /// none.
  core::Point through_wall(double arc, double across) const {
    const auto straight = [&](double at) -> core::Point {
      return (1 - across) * inner_.place(at) + across * outer_.place(at);
    };
    const double share = std::min(1.0, (arc - last_ring_) / (line_.length() - last_ring_));
    if (share <= 0) return straight(arc);
    return (1 - share) * straight(last_ring_) + share * rim_place(across);
  }

  core::Point rim_place(double across) const {
    const auto above = std::find_if(ends_.begin() + 1, ends_.end() - 1, [&](double end) { return end >= across; });
    const double from = *(above - 1), to = *above, share = (across - from) / (to - from);
    return (1 - share) * wall_.place(1, from) + share * wall_.place(1, to);
  }

  /// The cells were laid with the wall flat; seen from its other side they are mirrored.
  void turn_right_handed() {
    const auto& cell = result_.mesh.cells.back();
    const auto& x = result_.mesh.nodes;
    const Vector3 along = x[cell[14]] - x[cell[12]], around = x[cell[16]] - x[cell[10]],
                  across = x[cell[22]] - x[cell[4]];
    if (along.cross(around).dot(across) > 0) return;
    for (auto& one : result_.mesh.cells)
      for (std::size_t k = 0; k < 3; ++k) {
        std::swap(one[9 * k + 1], one[9 * k + 3]);
        std::swap(one[9 * k + 2], one[9 * k + 6]);
        std::swap(one[9 * k + 5], one[9 * k + 7]);
      }
    for (auto& face : result_.rim) face.axis = 1;
  }

  void add_planes() {
    if (division_.sector > 2 * M_PI - 1e-9) return;
    for (const double angle : {0.0, division_.sector}) {
      core::SymmetryPlane plane{{-std::sin(angle), std::cos(angle), 0}, {}};
      for (Index n = 0; n < result_.mesh.node_count(); ++n) {
        const Vector3& x = result_.mesh.nodes[n];
        if (std::abs(plane.normal.dot(x)) < 1e-9 && (x.dot(Vector3(std::cos(angle), std::sin(angle), 0)) >= -1e-12))
          plane.nodes.push_back(n);
      }
      result_.planes.push_back(std::move(plane));
    }
  }

  const WallCoordinates& wall_;
  const WallLine& line_;
  WallDivision division_;
  std::vector<double> ends_;
  SideLine inner_, outer_;
  double last_ring_;  ///< where the ring of cells at the rim begins, m
  WallMesh result_;
  std::map<std::tuple<long long, long long, long long>, Index> numbers_;
  std::map<std::pair<long long, long long>, std::map<long long, Index>> columns_;
};

/// Rings of cells about the axis: from `from` to `to` along the wall, m, over a sector that begins at an angle.
struct Rings {
  double from, to;
  Index count;
  double first_angle, sector;
  Index around;
  bool around_disc;  ///< the first begins at the border of a quarter disc, and they get round within its radius
};
void add_rings(WallBuilder& builder, const Rings& rings) {
  const auto place = [&](double ring, double share) {
    const double arc = rings.from + (rings.to - rings.from) * ring / rings.count;
    const double angle = rings.first_angle + rings.sector * share;
    std::array<double, 2> round{std::cos(angle), std::sin(angle)};
    const double way = std::min(rings.from, rings.to - rings.from);
    const double square = rings.around_disc ? std::max(0.0, 1 - (arc - rings.from) / way) : 0;
    if (square > 0) {
      const auto [x, y] = border_of_disc(share);
      const double cosine = std::cos(rings.first_angle), sine = std::sin(rings.first_angle);
      round = {(1 - square) * round[0] + square * (cosine * x - sine * y),
               (1 - square) * round[1] + square * (sine * x + cosine * y)};
    }
    return std::array{arc * round[0], arc * round[1]};
  };
  for (Index i = 0; i < rings.count; ++i)
    for (Index j = 0; j < rings.around; ++j)
      builder.add_stack([&](double u, double v) { return place(i + u, (j + v) / rings.around); }, i + 1 == rings.count);
}

Index divisions(double length, double size) {
  return std::max(Index{1}, static_cast<Index>(std::lround(length / size)));
}

/// `count` equal parts of a range, without its start.
void add_knots(double from, double to, Index count, std::vector<double>& knots) {
  for (Index i = 1; i <= count; ++i) knots.push_back(i == count ? to : from + (to - from) * double(i) / double(count));
}

}  // namespace

std::vector<double> layer_ends(Index layers) {
  constexpr double ratio = 1.7;  // of a layer to the one outside of it
  std::vector<double> ends{0};
  for (Index l = 0; l < layers; ++l) ends.push_back(ends.back() + std::pow(ratio, std::min(l, layers - 1 - l)));
  const double whole = ends.back();
  for (double& end : ends) end /= whole;
  return ends;
}

WallMesh turn_wall(const WallCoordinates& wall, const WallDivision& division) {
  const WallLine line(wall);
  const double quarter = M_PI_2, size = division.size, length = line.length();
  std::vector<double> knots{0};
  if (division.sector < quarter - 1e-9) {
    const Index count = divisions(length, size);
    add_knots(0, length, count, knots);
    WallBuilder builder(wall, line, division, knots);
    add_rings(builder, {0, length, count, 0, division.sector, divisions(line.widest() * division.sector, size), false});
    return builder.take();
  }
  // The square at the axis has half as many cells along a side as a quarter has around.
  const Index side = divisions(0.5 * quarter * line.widest(), size);
  constexpr double narrower = 0.6;  // cells of the square over those around the widest part
  const double disc = std::min(narrower * side * size, 0.5 * length);
  const Index rings = divisions(length - disc, size);
  add_knots(0, disc, side, knots);
  add_knots(disc, length, rings, knots);
  WallBuilder builder(wall, line, division, knots);
  const auto quarters = std::lround(division.sector / quarter);
  for (long q = 0; q < quarters; ++q) {
    const double turn = quarter * double(q), cosine = std::cos(turn), sine = std::sin(turn);
    for (Index i = 0; i < side; ++i)
      for (Index j = 0; j < side; ++j)
        builder.add_stack(
            [&](double u, double v) {
              const auto [x, y] = in_quarter_disc((i + u) / side, (j + v) / side);
              return std::array{disc * (cosine * x - sine * y), disc * (sine * x + cosine * y)};
            },
            false);
    add_rings(builder, {disc, length, rings, turn, quarter, 2 * side, true});
  }
  return builder.take();
}

}  // namespace parison::remesh
