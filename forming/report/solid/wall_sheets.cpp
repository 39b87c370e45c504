// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/wall_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "core/process/run_error.hpp"
#include "core/solid/hex_geometry.hpp"
#include "forming/report/solid/whole_turn.hpp"

namespace parison::forming {

namespace {

using core::Vector3;

/// How remesh::turn_wall lays the faces of a side: for each quarter of the sector a square at the axis, then rings
/// around it; in narrow sectors rings alone. Counts are of nodes less one.
struct Layout {
  int quarters;  ///< of the sector; 0: it is narrower
  int side;      ///< of the square; without one of a ring in the sector
  int rings;
  int around() const { return quarters > 0 ? 2 * side : side; }  ///< of a ring in a quarter, or in the sector
};

Layout layout_of(const SolidState& solid) {
  const auto inner = static_cast<int>(faces_of(solid, SolidSide::inner).size());
  const auto layers = static_cast<int>(solid.columns.front().size()) / 2;
  const auto around = static_cast<int>(faces_of(solid, SolidSide::rim).size()) / layers;
  const double quarters = 4 * solid.share, copies = 1 / solid.share;
  constexpr double rounding = 1e-6;
  const bool is_narrow = quarters < 1 - rounding;
  const double parts = is_narrow ? 0.5 * copies : quarters;
  if (std::abs(parts - std::round(parts)) > rounding)
    throw core::RunError(
        fmt::format("a sector of {:.4g} deg was found, allowed are 90, 180 and 360 deg, and even parts "
                    "of the turn below",
                    360 * solid.share));
  if (is_narrow) return {0, 2 * around, 2 * inner / around};
  const auto count = static_cast<int>(std::round(quarters));
  const int side = around / (2 * count);
  return {count, 2 * side, 2 * (inner / count - side * side) / (2 * side)};
}

/// Numbers of nodes, row by row.
struct NodeGrid {
  int columns;
  std::vector<Index> numbers;
  Index at(int row, int column) const { return numbers[std::size_t(row * columns + column)]; }
};

/// Nodes of a side of the sector, or of its rim with the rings going through the wall: quarter by quarter.
struct SectorGrids {
  Layout layout;
  std::vector<NodeGrid> squares, strips;
};

SectorGrids inner_grids(const SolidState& solid) {
  const Layout layout = layout_of(solid);
  const auto faces = faces_of(solid, SolidSide::inner);
  const bool is_mirrored = faces_of(solid, SolidSide::rim).front().axis == 1;
  std::size_t next = 0;
  const auto lay = [&](int rows, int columns) {
    NodeGrid grid{columns + 1, std::vector<Index>(std::size_t((rows + 1) * (columns + 1)))};
    for (int i = 0; i < rows; i += 2)
      for (int j = 0; j < columns; j += 2, ++next) {
        const auto numbers = core::face_node_numbers(solid.glass.mesh, faces.at(next));
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            grid.numbers[std::size_t((i + a) * grid.columns + j + b)] =
                numbers[std::size_t(is_mirrored ? b + 3 * a : a + 3 * b)];
      }
    return grid;
  };
  SectorGrids grids{layout, {}, {}};
  for (int q = 0; q < std::max(1, layout.quarters); ++q) {
    if (layout.quarters > 0) grids.squares.push_back(lay(layout.side, layout.side));
    grids.strips.push_back(lay(layout.rings, layout.around()));
  }
  return grids;
}

using Columns = std::map<Index, const std::vector<Index>*>;  // by their inner node

SectorGrids outer_grids(SectorGrids grids, const Columns& columns) {
  for (auto* some : {&grids.squares, &grids.strips})
    for (NodeGrid& grid : *some)
      for (Index& number : grid.numbers) number = columns.at(number)->back();
  return grids;
}

SectorGrids rim_grids(const SectorGrids& inner, const Columns& columns) {
  SectorGrids rim{inner.layout, {}, {}};
  rim.layout.rings = static_cast<int>(columns.begin()->second->size()) - 1;
  for (const NodeGrid& strip : inner.strips) {
    NodeGrid& grid = rim.strips.emplace_back(NodeGrid{strip.columns, {}});
    for (int through = 0; through <= rim.layout.rings; ++through)
      for (int place = 0; place < strip.columns; ++place)
        grid.numbers.push_back((*columns.at(strip.at(inner.layout.rings, place)))[std::size_t(through)]);
  }
  return rim;
}

/// A place of the first quarter turned into another one.
std::array<int, 2> turned(int quarter, int i, int j) {
  for (int q = 0; q < quarter; ++q) i = -std::exchange(j, i);
  return {i, j};
}

/// One side of the whole container, or its rim: rings of nodes about the axis, and the square that they close.
class Sheet {
 public:
  Sheet(const SolidState& solid, const SectorGrids& grids)
      : side_(grids.layout.side), rings_(grids.layout.rings), has_square_(!grids.squares.empty()) {
    const Copies copies(solid);
    const int parts = static_cast<int>(grids.strips.size()), here = grids.layout.around();
    pieces_ = copies.count() * parts * here / side_;
    strip_.resize(std::size_t((rings_ + 1) * around()));
    square_.resize(has_square_ ? std::size_t(width() * width()) : 0);
    for (int part = 0; part < copies.count() * parts; ++part) {
      const int copy = part / parts;
      const bool mirrored = Copies::is_mirrored(copy);
      const auto own = std::size_t(mirrored ? parts - 1 - part % parts : part % parts);
      const auto point = [&](Index node) { return copies.millimetres(solid.glass.mesh.nodes[node], copy); };
      for (int ring = 0; ring <= rings_; ++ring)
        for (int place = 0; place < here; ++place)
          strip_[std::size_t(ring * around() + part * here + place)] =
              point(grids.strips[own].at(ring, mirrored ? here - place : place));
      for (int i = 0; has_square_ && i <= side_; ++i)
        for (int j = 0; j <= side_; ++j)
          square_[square_place(part, i, j)] =
              point(mirrored ? grids.squares[own].at(j, i) : grids.squares[own].at(i, j));
    }
  }

  /// Of a few spans each: CAD kernels integrate over a face with a fixed number of points.
  void add_patches(std::vector<SplinePatch>& patches) const {
    const auto add = [&](const GridNode& node, int spans_v) {
      constexpr int most = 8;
      for (int u = 0; u < side_; u += most)
        for (int v = 0; v < spans_v; v += most)
          patches.push_back(spline_patch([&](int i, int j) { return node(u + i, v + j); }, std::min(most, side_ - u),
                                         std::min(most, spans_v - v)));
    };
    for (int quarter = 0; has_square_ && quarter < 4; ++quarter)
      add([&](int i, int j) { return square_node(quarter, i, j); }, side_);
    for (int piece = 0; piece < pieces_; ++piece)
      add([&](int place, int ring) { return strip_node(piece, place, ring); }, rings_);
  }

 private:
  int around() const { return pieces_ * side_; }
  int width() const { return 2 * side_ + 1; }
  std::size_t square_place(int quarter, int i, int j) const {
    const auto [x, y] = turned(quarter, i, j);
    return std::size_t((x + side_) * width() + y + side_);
  }
  const Vector3* in_strip(int ring, int place) const {
    return &strip_[std::size_t(ring * around() + (place + around()) % around())];
  }
  /// A node of a quarter of the square or of the rings beyond its border; none goes on from its corner.
  const Vector3* square_node(int quarter, int i, int j) const {
    if (i <= side_ && j <= side_) return &square_[square_place(quarter, i, j)];
    if (std::min(i, j) >= side_) return nullptr;
    return in_strip(std::max(i, j) - side_, 2 * side_ * quarter + (i > side_ ? j : 2 * side_ - i));
  }
  /// A node of a piece of the rings or beyond it. The border of the square bends at its corner, where every second
  /// piece ends.
  const Vector3* strip_node(int piece, int place, int ring) const {
    const bool to_corner = piece % 2 == 0;
    const bool is_round_corner = has_square_ && (to_corner ? place > side_ : place < 0);
    if (ring > rings_ || (is_round_corner && ring <= 0)) return nullptr;
    if (ring >= 0) return in_strip(ring, piece * side_ + place);
    if (!has_square_)  // opposite, where the first ring is a point of the axis
      return strip_[0] == strip_[1] ? in_strip(-ring, piece * side_ + place + around() / 2) : nullptr;
    const int inside = std::min(to_corner ? place : side_ - place, side_ + ring);
    return to_corner ? square_node(piece / 2, side_ + ring, inside) : square_node(piece / 2, inside, side_ + ring);
  }

  int side_, rings_, pieces_ = 0;
  bool has_square_;
  std::vector<Vector3> square_, strip_;  ///< mm
};

}  // namespace

std::vector<SplinePatch> wall_patches(const SolidState& solid) {
  Columns columns;
  for (const auto& column : solid.columns) columns[column.front()] = &column;
  const SectorGrids inner = inner_grids(solid);
  std::vector<SplinePatch> patches;
  for (const SectorGrids& grids : {inner, outer_grids(inner, columns), rim_grids(inner, columns)})
    Sheet(solid, grids).add_patches(patches);
  return patches;
}

}  // namespace parison::forming
