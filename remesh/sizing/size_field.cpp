// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/sizing/size_field.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "remesh/surface/curve.hpp"
#include "remesh/surface/film.hpp"
#include "remesh/surface/resample.hpp"
#include "remesh/surface/wall_thickness.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

constexpr int bins_along = 64;
constexpr int block = 8;             ///< bins along a block
constexpr double bin_radius = 0.75;  ///< of a circle around a bin, a little more than half its diagonal, of its edge

}  // namespace

SizeField::SizeField(std::vector<SizeSource> sources, double growth, double largest)
    : sources_(std::move(sources)), growth_(growth), largest_(largest) {
  if (sources_.empty()) return;
  core::Box box{sources_[0].at, sources_[0].at};
  for (const SizeSource& source : sources_) {
    box.low = box.low.cwiseMin(source.at);
    box.high = box.high.cwiseMax(source.at);
  }
  const double size = std::max((box.high - box.low).maxCoeff() / bins_along, largest_ * 1e-6);
  bins_ = {box, size};
  blocks_ = {box, block * size};
  in_bin_.resize(bins_.size());
  in_block_.resize(blocks_.size());
  all_.resize(sources_.size());
  std::iota(all_.begin(), all_.end(), 0);
}

double SizeField::target_size(const SizeSource& source, double distance) const {
  return source.size + growth_ * std::max(0.0, distance - source.reach);
}

std::vector<int> SizeField::candidates(const std::vector<int>& among, const Point& centre, double radius) const {
  double bound = largest_;
  for (const int i : among)
    bound = std::min(bound, target_size(sources_[i], (sources_[i].at - centre).norm() + radius));
  std::vector<int> result;
  for (const int i : among)
    if (target_size(sources_[i], (sources_[i].at - centre).norm() - radius) <= bound) result.push_back(i);
  return result;
}

const std::vector<int>& SizeField::candidates_in_block(const Point& x) const {
  const core::UniformGrid::Bin bin = blocks_.bin_at(x);
  auto& list = in_block_[blocks_.index(bin)];
  if (list.empty()) list = candidates(all_, blocks_.centre(bin), bin_radius * blocks_.bin_size());
  return list;
}

double SizeField::finest(const Point& x) const {
  double size = largest_;
  if (sources_.empty()) return size;
  const core::UniformGrid::Bin bin = bins_.bin_at(x);
  const Point centre = bins_.centre(bin);
  const double radius = bin_radius * bins_.bin_size();
  const auto least = [&](const std::vector<int>& list) {
    for (const int i : list) size = std::min(size, target_size(sources_[i], (sources_[i].at - x).norm()));
    return size;
  };
  if ((x - centre).norm() > radius) return least(candidates(all_, x, 0));
  auto& list = in_bin_[bins_.index(bin)];
  if (list.empty()) {
    list = candidates(candidates_in_block(centre), centre, radius);
    if (list.empty()) list.push_back(0);
  }
  return least(list);
}

Index parts_of(double length, double size) {
  return static_cast<Index>(std::ceil(length / size - core::round_off));
}

std::vector<double> divide(double length, const std::function<double(double)>& size, Index at_least) {
  std::vector<double> at{0}, integral{0};
  double before = size(0);
  while (at.back() < length) {
    double next = at.back() + 0.25 * before;
    if (next > length - 0.05 * before) next = length;
    const double here = size(next);
    integral.push_back(integral.back() + 0.5 * (next - at.back()) * (1 / before + 1 / here));
    at.push_back(next);
    before = here;
  }
  const double total = integral.back();
  const auto count = std::max(at_least, static_cast<Index>(std::ceil(total - 0.15)));
  std::vector<double> result{0};
  std::size_t k = 0;
  for (Index i = 1; i < count; ++i) {
    const double wanted = total * i / count;
    while (integral[k + 1] < wanted) ++k;
    const double fraction = (wanted - integral[k]) / (integral[k + 1] - integral[k]);
    result.push_back(at[k] + fraction * (at[k + 1] - at[k]));
  }
  result.push_back(length);
  return result;
}

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr Index max_samples = 64;  ///< of the wanted sizes along one old edge
/// Nodal value at s of an edge, linear between its three nodes; infinite where one of the two is.
template <class Nodal>
double along(const std::array<Index, 3>& edge, double s, const Nodal& value) {
  const double start = value(edge[s < 0.5 ? 0 : 2]), end = value(edge[s < 0.5 ? 2 : 1]),
               fraction = s < 0.5 ? 2 * s : 2 * s - 1;
  return fraction == 0 ? start : fraction == 1 ? end : (1 - fraction) * start + fraction * end;
}

/// Radius of curvature along each boundary edge: half of the kinks to its neighbours count as turning of the edge.
std::vector<double> curvature_radii(const Mesh& mesh) {
  const std::vector<Link> links = boundary_links(mesh);
  std::vector<double> radii(mesh.boundary_edges().size());
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const auto& edge = mesh.boundary_edges()[i].nodes;
    double turn = turning(tangent(mesh, edge, 0), tangent(mesh, edge, 1));
    for (const double kink : {links[i].kink, links[links[i].next].kink})
      if (std::abs(kink) < corner_angle) turn += 0.5 * kink;
    radii[i] = std::abs(turn) > 1e-9 ? arc_length(mesh, edge, 1) / std::abs(turn) : core::infinity;
  }
  return radii;
}

/// About how many cells of these sizes fill the body: equilateral ones.
double cell_count(const Mesh& old, const SizeField& size) {
  double count = 0;
  for (const auto& cell : old.cells()) {
    const Point &a = old.nodes[cell[0]], u = old.nodes[cell[1]] - a, v = old.nodes[cell[2]] - a;
    const double edge = size(a + (u + v) / 3);
    count += 0.5 * std::abs(u[0] * v[1] - u[1] * v[0]) / (std::sqrt(3.0) / 4 * edge * edge);
  }
  return count;
}

/// What the criteria ask for inside, where that is finer than the size there without anything else.
void add_target_cell_sizes(const Mesh& old, const Criteria& criteria, std::vector<SizeSource>& sources) {
  for (std::size_t cell = 0; cell < criteria.target_cell_size.size(); ++cell) {
    const double target_size = std::max(criteria.target_cell_size[cell], criteria.min_size);
    if (target_size >= 2 * criteria.surface_size) continue;
    const auto& nodes = old.cells()[cell];
    const Point &a = old.nodes[nodes[0]], &b = old.nodes[nodes[1]], &c = old.nodes[nodes[2]], middle = (a + b + c) / 3;
    sources.push_back({middle, target_size, std::min({(a - middle).norm(), (b - middle).norm(), (c - middle).norm()})});
  }
}

}  // namespace

SizeField size_field(const Mesh& old, const Criteria& criteria) {
  const remesh::Wall behind = remesh::surface_wall(old);
  Eigen::VectorXd wall = behind.thickness;
  remesh::spread_inward(old, wall);
  const Eigen::VectorXd film = film_thickness(old, behind, criteria.contact);
  const std::vector<double> radii = curvature_radii(old);
  std::vector<SizeSource> sources;
  for (std::size_t i = 0; i < old.boundary_edges().size(); ++i) {
    const auto& edge = old.boundary_edges()[i].nodes;
    if (criteria.straight_boundaries.at(old.boundary_edges()[i].boundary_id)) continue;
    const double bend = std::max(max_turn * radii[i], criteria.min_size);
    const auto skin = [&](Index node) {
      return criteria.target_skin_size.empty() ? core::infinity : criteria.target_skin_size[node];
    };
    const auto least = [&](const auto& at) { return std::min({at(edge[0]), at(edge[1]), at(edge[2])}); };
    const double min_thickness = least([&](Index node) { return wall[node]; });
    const double film_edge = film_size(least([&](Index node) { return film[node]; }), criteria.min_film_thickness);
    const double finest = std::min(
        film_edge, std::max(std::min(min_thickness / criteria.elements_across, least(skin)), criteria.min_size));
    const Index steps = std::clamp(parts_of(arc_length(old, edge, 1), finest), 2, max_samples);
    for (Index k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / steps;
      const Point at = point_on(old, edge, s);
      const double thickness = along(edge, s, [&](Index node) { return wall[node]; });
      const double in_film =
          film_size(along(edge, s, [&](Index node) { return film[node]; }), criteria.min_film_thickness);
      const double across = std::min(in_film, std::max(thickness / criteria.elements_across, criteria.min_size));
      const double target_size = std::max({along(edge, s, skin), criteria.skin_size, criteria.min_size});
      sources.push_back({at, std::min({criteria.surface_size, across, bend, target_size}), 0});
      if (across < 2 * criteria.surface_size) sources.push_back({at, across, 0.5 * thickness});
    }
  }
  add_target_cell_sizes(old, criteria, sources);
  SizeField size(std::move(sources), criteria.growth, 2 * criteria.surface_size);
  size.coarsen(std::sqrt(std::max(1.0, cell_count(old, size) / criteria.max_cells)));
  return size;
}

}  // namespace parison::remesh
