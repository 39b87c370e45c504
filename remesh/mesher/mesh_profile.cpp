// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/mesh_profile.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/process/run_error.hpp"
#include "remesh/mesher/mesh_outline.hpp"
#include "remesh/surface/resample.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

std::vector<core::MeshBoundary> boundaries_of(const core::Profile& profile) {
  return {profile.boundary_names.begin(), profile.boundary_names.end()};
}

std::vector<SizeSource> size_sources(const core::Profile& profile, const ProfileSizes& sizes) {
  std::vector<SizeSource> sources = sizes.sources;
  for (const core::Segment& segment : profile.segments) {
    double target_size = sizes.fine_boundaries.at(segment.boundary_id) ? sizes.contact_size : sizes.size;
    if (segment.is_arc) target_size = std::min(target_size, max_turn * segment.radius);
    if (target_size >= sizes.size) continue;
    const Index count = parts_of(core::length(segment), target_size);
    for (Index i = 0; i <= count; ++i)
      sources.push_back({core::point_at(segment, static_cast<double>(i) / count), target_size, target_size});
  }
  return sources;
}

}  // namespace

core::Mesh mesh_profile(const core::Profile& profile, const ProfileSizes& sizes) {
  const SizeField field(size_sources(profile, sizes), sizes.growth, sizes.size);
  Outline outline;
  for (const core::Segment& segment : profile.segments) {
    const double length = core::length(segment);
    const std::vector<double> at = divide(
        length, [&](double s) { return field(core::point_at(segment, s / length)); }, 1);
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      outline.vertices.push_back(i == 0 ? segment.start : core::point_at(segment, at[i] / length));
      outline.mids.push_back(core::point_at(segment, 0.5 * (at[i] + at[i + 1]) / length));
      outline.boundary_ids.push_back(segment.boundary_id);
    }
  }
  outline.loop_start.push_back(outline.edge_count());
  MeshedOutline result = mesh_outline(outline, boundaries_of(profile), field, triangulate, sizes.has_skin);
  if (!result.reason.empty()) throw core::RunError("the profile cannot be meshed: " + result.reason);
  return std::move(result.mesh);
}

namespace {

/// One side of the body: the segments of a boundary as one curve over [0, 1], uniform in arc length.
struct Side {
  std::vector<core::Segment> segments;
  double length = 0;

  Point operator()(double t) const {
    double s = t * length;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const double own = core::length(segments[i]);
      if (s <= own || i + 1 == segments.size()) {
        const double fraction = s / own;
        return fraction <= 0   ? segments[i].start
               : fraction >= 1 ? segments[i].end
                               : core::point_at(segments[i], fraction);
      }
      s -= own;
    }
    return segments.back().end;
  }
};

std::array<Side, 4> sides(const core::Profile& profile) {
  const std::size_t count = profile.segments.size();
  const auto boundary_id = [&](std::size_t i) { return profile.segments[i % count].boundary_id; };
  std::size_t start = 0;
  while (start < count && !(boundary_id(start) == 0 && boundary_id(start + count - 1) != 0)) ++start;
  std::array<Side, 4> result;
  int side = -1;
  for (std::size_t i = start; i < start + count; ++i) {
    if (i == start || boundary_id(i) != boundary_id(i - 1)) ++side;
    if (side > 3 || start == count) break;
    result[side].segments.push_back(profile.segments[i % count]);
    result[side].length += core::length(result[side].segments.back());
  }
  if (side != 3 || profile.boundary_names.size() != 4)
    throw std::invalid_argument("a mapped mesh needs an outline of exactly four boundaries");
  return result;
}

/// Parameters of the division points and of the middles between them: 2 count + 1 values in [0, 1]. The divisions are a
/// geometric progression with the given ratio of the last to the first.
std::vector<double> graded(Index count, double ratio) {
  const double factor = count > 1 ? std::pow(ratio, 1.0 / (count - 1)) : 1.0;
  std::vector<double> ends{0};
  for (Index i = 0; i < count; ++i) ends.push_back(ends.back() + std::pow(factor, i));
  std::vector<double> result;
  for (Index i = 0; i < count; ++i) {
    result.push_back(ends[i] / ends[count]);
    result.push_back(0.5 * (ends[i] + ends[i + 1]) / ends[count]);
  }
  result.push_back(1);
  return result;
}

/// Bilinearly blended Coons patch over the unit square with the sides at v = 0, u = 1, v = 1, u = 0. Points on the
/// border are evaluated on the sides themselves, without rounding of the blend.
Point coons(const std::array<Side, 4>& side, double u, double v) {
  if (v == 0) return side[0](u);
  if (u == 1) return side[1](v);
  if (v == 1) return side[2](1 - u);
  if (u == 0) return side[3](1 - v);
  const Point along = (1 - v) * side[0](u) + v * side[2](1 - u);
  const Point across = (1 - u) * side[3](1 - v) + u * side[1](v);
  const Point corners = (1 - u) * ((1 - v) * side[0](0) + v * side[2](1)) + u * ((1 - v) * side[0](1) + v * side[2](0));
  return along + across - corners;
}

/// Node numbers on a lattice of (2 columns + 1) x (2 rows + 1) points: vertices at even indices, numbered first.
struct Lattice {
  Index columns, rows;

  Index operator()(Index i, Index j) const {
    const Index width = 2 * columns + 1, vertices = (columns + 1) * (rows + 1);
    if (i % 2 == 0 && j % 2 == 0) return j / 2 * (columns + 1) + i / 2;
    const Index vertices_before = j % 2 == 0 ? j / 2 * (columns + 1) + (i + 1) / 2 : (j + 1) / 2 * (columns + 1);
    return vertices + j * width + i - vertices_before;
  }
};

void add_cells(Mesh& mesh, const Lattice& at, Index i, Index j) {
  const Index a = at(i, j), b = at(i + 2, j), c = at(i + 2, j + 2), d = at(i, j + 2), centre = at(i + 1, j + 1);
  const Index ab = at(i + 1, j), bc = at(i + 2, j + 1), cd = at(i + 1, j + 2), da = at(i, j + 1);
  const auto distance = [&](Index p, Index q) { return (mesh.nodes[p] - mesh.nodes[q]).norm(); };
  if (distance(a, c) <= distance(b, d) * (1 + 1e-9)) {
    mesh.edit().cells.push_back({a, b, c, ab, bc, centre});
    mesh.edit().cells.push_back({a, c, d, centre, cd, da});
  } else {
    mesh.edit().cells.push_back({a, b, d, ab, centre, da});
    mesh.edit().cells.push_back({b, c, d, bc, cd, centre});
  }
}

Index owner(const Mesh& mesh, Index mid) {
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (int k = 3; k < 6; ++k)
      if (mesh.cells()[cell][k] == mid) return cell;
  return -1;
}

void add_side(Mesh& mesh, const Lattice& at, Index side, Index boundary_id) {
  const Index right = 2 * at.columns, top = 2 * at.rows;
  const auto node = [&](Index k) {
    return side == 0 ? at(k, 0) : side == 1 ? at(right, k) : side == 2 ? at(right - k, top) : at(0, top - k);
  };
  for (Index k = 0; k < (side % 2 == 0 ? right : top); k += 2)
    mesh.edit().boundary_edges.push_back({{node(k), node(k + 2), node(k + 1)}, owner(mesh, node(k + 1)), boundary_id});
}

}  // namespace

core::Mesh mesh_mapped(const core::Profile& profile, Index along_first, Index along_second, double ratio_first,
                       double ratio_second) {
  const std::array<Side, 4> side = sides(profile);
  const Lattice at{along_first, along_second};
  const std::vector<double> u = graded(along_first, ratio_first), v = graded(along_second, ratio_second);
  Mesh mesh;
  mesh.edit().boundaries = boundaries_of(profile);
  mesh.edit().vertex_count = (at.columns + 1) * (at.rows + 1);
  mesh.nodes.resize(u.size() * v.size());
  for (std::size_t j = 0; j < v.size(); ++j)
    for (std::size_t i = 0; i < u.size(); ++i)
      mesh.nodes[at(static_cast<Index>(i), static_cast<Index>(j))] = coons(side, u[i], v[j]);
  for (Index j = 0; j < 2 * at.rows; j += 2)
    for (Index i = 0; i < 2 * at.columns; i += 2) add_cells(mesh, at, i, j);
  for (Index k = 0; k < 4; ++k) add_side(mesh, at, k, side[k].segments[0].boundary_id);
  return mesh;
}

}  // namespace parison::remesh
