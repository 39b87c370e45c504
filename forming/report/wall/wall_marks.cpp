// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/wall/wall_marks.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"

namespace parison::forming {
namespace {

/// Room around the middle of a ray between the sides of the wall over its length; less where it runs along the wall.
constexpr double least_room = 0.5;
/// Least cosine between a ray and the normal at its end beside a rim, where the sides bend towards each other.
constexpr double facing_at_rim = 0.97;

/// Which rows lie between a free rim, which may be round, and the first ray that meets the other side face to face;
/// where none does so within one and a half times its length, as in a wall that tapers, up to the nearest pair that
/// tells the sides.
class RowsBesideRim {
 public:
  RowsBesideRim(const std::vector<ThicknessRow>& rows, const std::vector<Index>& nodes,
                const std::vector<remesh::Ray>& rays, const std::vector<bool>& on_rim, const std::vector<bool>& held,
                const std::vector<bool>& paired)
      : rows_(rows), nodes_(nodes), rays_(rays), on_rim_(on_rim), paired_(paired), beside_(rows.size(), false) {
    const auto count = static_cast<Index>(rows.size());
    for (Index i = 0; i < count; ++i) {
      if (!on_rim_[nodes_[i]] || held[nodes_[i]]) continue;
      if (i + 1 < count && !on_rim_[nodes_[i + 1]]) mark(i, 1);
      if (i > 0 && !on_rim_[nodes_[i - 1]]) mark(i, -1);
    }
  }
  bool operator[](std::size_t row) const { return beside_[row]; }

 private:
  /// Marks rows from the last one of a rim on.
  void mark(Index rim, Index step) {
    constexpr double reach = 1.5;
    const Index count = static_cast<Index>(rows_.size());
    Index faces = rim + step, pair = -1;
    for (; faces >= 0 && faces < count; faces += step) {
      const remesh::Ray& ray = rays_[nodes_[faces]];
      if (pair < 0 && paired_[nodes_[faces]]) pair = faces;
      if (ray.ends() && ray.facing >= facing_at_rim) break;
      if (ray.ends() && std::abs(rows_[faces].arc - rows_[rim].arc) > reach * ray.length && pair >= 0) {
        faces = pair;
        break;
      }
    }
    for (Index i = rim; i != faces; i += step) beside_[i] = true;
  }

  const std::vector<ThicknessRow>& rows_;
  const std::vector<Index>& nodes_;
  const std::vector<remesh::Ray>& rays_;
  const std::vector<bool>&on_rim_, &paired_;
  std::vector<bool> beside_;
};

/// Cosine of the angle between a ray and the normal where it ends, and the least one of a wall.
struct Facing {
  double least = core::none, is = core::none;
};

/// The nodes of rims, and those at which the two sides meet.
std::vector<bool> nodes_on_rim(const core::Mesh& mesh, const remesh::WallSides& sides) {
  std::vector<bool> on_rim(mesh.nodes.size(), false), outer = on_rim, inner = on_rim;
  for (std::size_t edge = 0; edge < sides.part.size(); ++edge)
    for (const Index node : mesh.boundary_edges()[edge].nodes) {
      if (sides.part[edge] == remesh::SurfacePart::rim) on_rim[node] = true;
      if (sides.part[edge] == remesh::SurfacePart::outer) outer[node] = true;
      if (sides.part[edge] == remesh::SurfacePart::inner) inner[node] = true;
    }
  for (std::size_t node = 0; node < on_rim.size(); ++node) on_rim[node] = on_rim[node] || (outer[node] && inner[node]);
  return on_rim;
}

/// The nodes of boundaries of a kind.
std::vector<bool> nodes_of_kind(const core::Mesh& mesh, BoundaryKind kind) {
  const std::vector<bool> wanted = core::boundaries_of_kind(mesh, kind);
  std::vector<bool> found(mesh.nodes.size(), false);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) found[node] = found[node] || wanted[edge.boundary_id];
  return found;
}

/// Whether a ray from the outer side ends on the other one; of a mirrored wall, on its mirror image.
bool ends_opposite(const remesh::WallSides& sides, const remesh::Ray& ray) {
  const remesh::SurfacePart opposite = sides.is_mirrored ? remesh::SurfacePart::outer : remesh::SurfacePart::inner;
  return ray.ends() && sides.part[ray.edge] == opposite && !(sides.is_mirrored && ray.reflections % 2 == 0);
}

/// Rows whose ray ends on the other side become wall, those between the sides rim, all others foot. Returned is for
/// each row what its ray has to face the other side by, and faces it by; NaN where something else decides.
std::vector<Facing> mark_rows(const core::Mesh& mesh, const remesh::WallSides& sides,
                              const std::vector<remesh::Ray>& rays, const std::vector<Index>& nodes,
                              std::vector<ThicknessRow>& rows) {
  const std::vector<bool> both = edges_of(sides, {remesh::SurfacePart::outer, remesh::SurfacePart::inner});
  const std::vector<bool> on_rim = nodes_on_rim(mesh, sides);
  const RowsBesideRim beside_rim(rows, nodes, rays, on_rim, nodes_of_kind(mesh, BoundaryKind::fixed), sides.paired);
  std::vector<Facing> facing(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const remesh::Ray& ray = rays[nodes[i]];
    rows[i].mark = on_rim[nodes[i]] ? WallMark::rim : WallMark::foot;
    if (on_rim[nodes[i]] || !ends_opposite(sides, ray)) continue;
    if (2 * remesh::distance_to_edges(mesh, both, ray.middle) < least_room * ray.length) continue;
    facing[i] = {beside_rim[i] ? facing_at_rim : remesh::facing_sides, ray.facing};
    if (facing[i].is < facing[i].least) continue;
    rows[i].mark = WallMark::wall;
    rows[i].thickness = ray.length;
    rows[i].inner_position = ray.end;
  }
  return facing;
}

/// Rows [begin, end) that are wall one after the other, and their length, a mirror image included, m.
struct Stretch {
  std::size_t begin, end;
  double length;
};
std::vector<Stretch> wall_stretches(const core::Mesh& mesh, const std::vector<Index>& nodes,
                                    const std::vector<ThicknessRow>& rows) {
  const std::vector<bool> on_symmetry = nodes_of_kind(mesh, BoundaryKind::symmetry);  // the mirror image goes on
  std::vector<Stretch> stretches;
  for (std::size_t begin = 0; begin < rows.size(); ++begin) {
    std::size_t end = begin;
    while (end < rows.size() && rows[end].is_wall()) ++end;
    if (end == begin) continue;
    const bool goes_on = on_symmetry[nodes[begin]] || on_symmetry[nodes[end - 1]];
    stretches.push_back({begin, end, (goes_on ? 2 : 1) * (rows[end - 1].arc - rows[begin].arc)});
    begin = end - 1;
  }
  return stretches;
}

void take_off(ThicknessRow& row, WallMark mark) {
  row.mark = mark;
  row.thickness = core::none;
  row.inner_position = Point::Constant(core::none);
}

/// A short stretch of wall is none: a roll at a rim, or rays from a heel or a bead that happen to meet the other side.
/// What is no wall beside a rim is rim.
void clean_marks(const core::Mesh& mesh, const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows) {
  const std::vector<Stretch> stretches = wall_stretches(mesh, nodes, rows);
  double longest = 0;
  for (const Stretch& stretch : stretches) longest = std::max(longest, stretch.length);
  for (const Stretch& stretch : stretches) {
    const double least = stretch.length < longest ? least_wall_length : 1;
    double thickest = 0;
    for (std::size_t i = stretch.begin; i < stretch.end; ++i) thickest = std::max(thickest, rows[i].thickness);
    for (std::size_t i = stretch.begin; i < stretch.end && stretch.length < least * thickest; ++i)
      take_off(rows[i], WallMark::foot);
  }
  const auto spread = [&](std::size_t from, std::size_t to) {
    if (rows[from].mark == WallMark::rim && rows[to].mark == WallMark::foot) rows[to].mark = WallMark::rim;
  };
  for (std::size_t i = 1; i < rows.size(); ++i) spread(i - 1, i);
  for (std::size_t i = rows.size(); i-- > 1;) spread(i, i - 1);
}

/// Moves area from a row that is no wall to the row of the wall beside it, or back, so that the wall ends at the corner
/// where a rim begins, or where the facing of the rays between them passes what a wall must have: as areas are by node,
/// it would end by chance of the mesh.
void end_wall_between_rows(const core::Mesh& mesh, core::Geometry geometry, const std::vector<Index>& nodes,
                           const std::vector<Facing>& facing, std::vector<ThicknessRow>& rows) {
  constexpr double of_middle = 2.0 / 3;  // of half an edge; the rest is that of its end
  std::vector<bool> is_middle(mesh.nodes.size(), false);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) is_middle[edge.nodes[2]] = true;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t wall = rows[i].is_wall() ? i : i - 1, other = rows[i].is_wall() ? i - 1 : i;
    const double length = rows[i].arc - rows[i - 1].arc;
    const bool are_neighbours = is_middle[nodes[i]] != is_middle[nodes[i - 1]] && length > 0 &&
                                (rows[i].position - rows[i - 1].position).norm() < 1.01 * length;
    if (!rows[wall].is_wall() || rows[other].is_wall() || !are_neighbours) continue;
    const auto angle = [](double cosine) { return std::acos(std::min(cosine, 1.0)); };
    const double here = angle(facing[wall].is), beyond = angle(facing[other].is);
    const double most = std::fmin(angle(facing[wall].least), angle(facing[other].least));
    const bool ends_at_corner = rows[other].mark == WallMark::rim && std::isnan(beyond);
    if (!ends_at_corner && !(here <= most && most < beyond)) continue;
    const double share = ends_at_corner ? 1 : (most - here) / (beyond - here);
    const double counted = is_middle[nodes[wall]] ? of_middle : 1 - of_middle;
    const double moved =
        (share - counted) * length * core::depth(geometry, 0.5 * (rows[i].position + rows[i - 1].position));
    rows[wall].area += moved;
    rows[other].area -= moved;
  }
}

/// The area of a foot within the wall goes to the rows beside it where the foot is shorter than the wall there is thick
/// and its rays end on the other side and are hardly longer, as where the outer side turns a little: how squarely they
/// meet the other side is on the edge of what a wall has there, and the mesh would decide about the mean. Rays of a
/// heel are longer.
void share_area_of_short_feet(const remesh::WallSides& sides, const std::vector<remesh::Ray>& rays,
                              const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows) {
  constexpr double hardly_longer = 1.2;
  const auto is_doubtful = [&](std::size_t i) {
    return rows[i].mark == WallMark::foot && ends_opposite(sides, rays[nodes[i]]);
  };
  for (std::size_t begin = 1; begin < rows.size(); ++begin) {
    std::size_t end = begin;
    while (end < rows.size() && is_doubtful(end)) ++end;
    if (end == begin || end == rows.size() || !rows[begin - 1].is_wall() || !rows[end].is_wall()) continue;
    const auto [thinner, thicker] = std::minmax({rows[begin - 1].thickness, rows[end].thickness});
    if (rows[end].arc - rows[begin - 1].arc >= thinner) continue;
    const auto is_long = [&, longest = hardly_longer * thicker](Index node) { return rays[node].length > longest; };
    if (std::any_of(nodes.begin() + Index(begin), nodes.begin() + Index(end), is_long)) continue;
    for (std::size_t i = begin; i < end; ++i) {
      for (const std::size_t wall : {begin - 1, end}) rows[wall].area += 0.5 * rows[i].area;
      rows[i].area = 0;
    }
  }
}

}  // namespace

std::vector<bool> edges_of(const remesh::WallSides& sides, std::initializer_list<remesh::SurfacePart> wanted) {
  std::vector<bool> edges;
  for (const remesh::SurfacePart part : sides.part)
    edges.push_back(std::find(wanted.begin(), wanted.end(), part) != wanted.end());
  return edges;
}

void mark_wall(const core::Mesh& mesh, core::Geometry geometry, const remesh::WallSides& sides,
               const std::vector<remesh::Ray>& rays, const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows) {
  const std::vector<Facing> facing = mark_rows(mesh, sides, rays, nodes, rows);
  clean_marks(mesh, nodes, rows);
  end_wall_between_rows(mesh, geometry, nodes, facing, rows);
  share_area_of_short_feet(sides, rays, nodes, rows);
}

double wall_length(const core::Mesh& mesh, const std::vector<Index>& nodes, const std::vector<ThicknessRow>& rows) {
  double length = 0;
  for (const Stretch& stretch : wall_stretches(mesh, nodes, rows)) length += stretch.length;
  return length;
}

}  // namespace parison::forming
