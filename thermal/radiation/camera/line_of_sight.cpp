// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/camera/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/mesh/element.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::thermal {

namespace {

/// How far reference coordinates lie outside the triangle; 0 or less inside.
double outside(const std::array<double, 2>& at) {
  return std::max({-at[0], -at[1], at[0] + at[1] - 1});
}

}  // namespace

FieldAtPoints::FieldAtPoints(const core::Mesh& mesh, Eigen::VectorXd field) : mesh_(mesh), field_(std::move(field)) {
  core::Point high = low_ = mesh.nodes.front();
  for (const core::Point& x : mesh.nodes) {
    low_ = low_.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const core::Point extent = high - low_;
  width_ = std::sqrt(std::max(extent[0] * extent[1], 1e-6 * extent.squaredNorm()) / mesh.cell_count());
  for (int d = 0; d < 2; ++d) count_[d] = 1 + static_cast<long>(extent[d] / width_);
  cells_.resize(static_cast<std::size_t>(count_[0] * count_[1]));
  for (core::Index c = 0; c < mesh.cell_count(); ++c) {
    maps_.push_back(core::cell_map(mesh, c));
    core::Point from = mesh.nodes[mesh.cells()[c][0]], to = from;
    for (const core::Index node : mesh.cells()[c]) {
      from = from.cwiseMin(mesh.nodes[node]);
      to = to.cwiseMax(mesh.nodes[node]);
    }
    const core::Point margin = 0.1 * (to - from);
    const auto first = bin(from - margin), last = bin(to + margin);
    for (long j = first[1]; j <= last[1]; ++j)
      for (long i = first[0]; i <= last[0]; ++i) cells_[static_cast<std::size_t>(i + count_[0] * j)].push_back(c);
  }
}

std::array<long, 2> FieldAtPoints::bin(const core::Point& x) const {
  std::array<long, 2> at{};
  for (int d = 0; d < 2; ++d)
    at[d] = std::clamp(static_cast<long>(std::floor((x[d] - low_[d]) / width_)), 0L, count_[d] - 1);
  return at;
}

double FieldAtPoints::operator()(const core::Point& x) const {
  const auto at = bin(x);
  double nearest = std::numeric_limits<double>::infinity();
  core::Index cell = -1;
  std::array<double, 2> reference{};
  for (const core::Index c : cells_[static_cast<std::size_t>(at[0] + count_[0] * at[1])]) {
    const auto found = core::invert(maps_[static_cast<std::size_t>(c)], x);
    const double off = outside(found);
    if (!(off < nearest)) continue;
    nearest = off, cell = c, reference = found;
    if (off <= 0) break;
  }
  if (cell < 0) return field_.mean();
  for (double& r : reference) r = std::clamp(r, 0.0, 1.0);
  if (const double sum = reference[0] + reference[1]; sum > 1)
    for (double& r : reference) r /= sum;
  const auto shape = core::triangle_shape(reference[0], reference[1]);
  double value = 0;
  for (int i = 0; i < 6; ++i) value += shape[i] * field_[mesh_.cells()[cell][i]];
  return value;
}

namespace {

constexpr double least_share = 1e-4;  ///< of a beam that is still followed; what is left sees what it left
constexpr int most_surfaces = 24;     ///< that a beam meets
constexpr int intervals = 24;         ///< of a path through the glass, shortest at its ends, where the skins are

Eigen::Vector3d reflected(const Eigen::Vector3d& d, const Eigen::Vector3d& normal) {
  return (d - 2 * d.dot(normal) * normal).normalized();
}

/// Behind a surface whose normal points to where the ray goes; `ratio` of the index before to that behind, cosines
/// before and behind (Snell).
Eigen::Vector3d refracted(const Eigen::Vector3d& d, const Eigen::Vector3d& normal, double ratio, double before,
                          double behind) {
  return (ratio * d + (behind - ratio * before) * normal).normalized();
}

/// The normal of the quadratic edge where it and that of the facet agree which side of the surface the ray comes from.
Eigen::Vector3d usable_normal(const Section& section, const Hit& hit, const Ray& ray) {
  const Eigen::Vector3d x = ray.at(hit.distance), facet = section.facet_normal(hit.facet, x);
  const Eigen::Vector3d smooth = section.normal(hit.edge, hit.s, x);
  return smooth.dot(ray.direction) * facet.dot(ray.direction) > 0 ? smooth : facet;
}

}  // namespace

Optics optics_of(const Material& material) {
  const double everything = std::numeric_limits<double>::infinity();
  if (!material.radiation) return {1.5, {}};
  if (material.radiation->bands.empty())
    return {material.radiation->refractive_index,
            {{everything, material.radiation->absorption, material.radiation->relative}}};
  return {material.radiation->refractive_index, material.radiation->bands};
}

LineOfSight::LineOfSight(const core::Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& temperature,
                         const Optics& optics, CameraBand band, double surroundings)
    : index_(optics.refractive_index),
      surroundings_(surroundings),
      whole_(band.from, band.to),
      section_(mesh, geometry),
      temperature_(mesh, temperature) {
  double from = band.from;
  for (const Band& part : optics.bands) {
    if (part.up_to <= from) continue;
    const double to = std::min(part.up_to, band.to);
    if (to > from) parts_.push_back({BandEmission(from, to), part.absorption, part.relative});
    from = std::max(from, to);
  }
  if (from < band.to) parts_.push_back({BandEmission(from, band.to), std::numeric_limits<double>::infinity(), {}});
}

Eigen::ArrayXd LineOfSight::emission(double temperature) const {
  Eigen::ArrayXd of_part(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) of_part[i] = parts_[i].emission.value(temperature) / M_PI;
  return of_part;
}

/// Light along a path, its source linear in the optical depth between places; `share` becomes that behind the path.
/// Divided by the square of the index, which the surface takes away again.
double LineOfSight::emitted_along(const Ray& ray, double length, Eigen::ArrayXd& share) const {
  double sum = 0, last = 0, before = temperature_(section_.project(ray.at(0)));
  Eigen::ArrayXd source = emission(before);
  for (int k = 1; k <= intervals; ++k) {
    const double at = 0.5 * length * (1 - std::cos(M_PI * k / intervals));
    const double temperature = temperature_(section_.project(ray.at(at)));
    const Eigen::ArrayXd next = emission(temperature);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const double absorption = 0.5 * (parts_[i].absorption_at(before) + parts_[i].absorption_at(temperature));
      const double depth = absorption * (at - last), passed = std::exp(-depth);
      const double share_of_end = depth > 1e-4 ? (1 - passed) / depth : 1 - depth / 2 + depth * depth / 6;
      sum += share[i] * ((1 - share_of_end) * source[i] + (share_of_end - passed) * next[i]);
      share[i] *= passed;
    }
    source = next;
    last = at, before = temperature;
  }
  return sum;
}

void LineOfSight::follow_outside(Beam beam, double& sum, std::vector<Beam>& beams) const {
  const auto hit = section_.enter(beam.ray, beam.facet);
  if (!hit) {
    sum += (beam.share * emission(surroundings_)).sum();
    return;
  }
  const Eigen::Vector3d x = beam.ray.at(hit->distance), normal = usable_normal(section_, *hit, beam.ray);
  const double outside = -normal.dot(beam.ray.direction);
  const double inside = std::sqrt(1 - (1 - outside * outside) / (index_ * index_));
  const double reflectivity = fresnel_reflectivity(index_, inside), temperature = temperature_(section_.project(x));
  const Eigen::ArrayXd of_surface = emission(temperature);
  Eigen::ArrayXd entering = (1 - reflectivity) * beam.share;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    if (std::isinf(parts_[i].absorption)) {
      sum += entering[i] * of_surface[i];
      entering[i] = 0;
    }
  const int surfaces = beam.surfaces + 1;
  beams.push_back({{x, refracted(beam.ray.direction, -normal, 1 / index_, outside, inside)},
                   hit->facet,
                   true,
                   surfaces,
                   temperature,
                   std::move(entering)});
  beams.push_back({{x, reflected(beam.ray.direction, normal)},
                   hit->facet,
                   false,
                   surfaces,
                   temperature,
                   reflectivity * beam.share});
}

void LineOfSight::follow_inside(Beam beam, double& sum, std::vector<Beam>& beams) const {
  const auto hit = section_.leave(beam.ray, beam.facet);
  if (!hit) {
    sum += (beam.share * emission(beam.temperature)).sum();
    return;
  }
  sum += emitted_along(beam.ray, hit->distance, beam.share);
  const Eigen::Vector3d x = beam.ray.at(hit->distance), normal = usable_normal(section_, *hit, beam.ray);
  const double inside = std::min(1.0, normal.dot(beam.ray.direction));
  const double reflectivity = fresnel_reflectivity(index_, inside), temperature = temperature_(section_.project(x));
  const int surfaces = beam.surfaces + 1;
  if (reflectivity < 1) {
    const double outside = std::sqrt(std::max(0.0, 1 - (1 - inside * inside) * index_ * index_));
    beams.push_back({{x, refracted(beam.ray.direction, normal, index_, inside, outside)},
                     hit->facet,
                     false,
                     surfaces,
                     temperature,
                     (1 - reflectivity) * beam.share});
  }
  beams.push_back(
      {{x, reflected(beam.ray.direction, normal)}, hit->facet, true, surfaces, temperature, reflectivity * beam.share});
}

double LineOfSight::radiance(const Ray& ray) const {
  double sum = 0;
  std::vector<Beam> beams{{ray, -1, false, 0, surroundings_, Eigen::ArrayXd::Ones(parts_.size())}};
  while (!beams.empty()) {
    Beam beam = std::move(beams.back());
    beams.pop_back();
    if (beam.share.maxCoeff() < least_share || beam.surfaces > most_surfaces)
      sum += (beam.share * emission(beam.temperature)).sum();
    else if (beam.inside)
      follow_inside(std::move(beam), sum, beams);
    else
      follow_outside(std::move(beam), sum, beams);
  }
  return sum;
}

double LineOfSight::surface_temperature(const Ray& ray) const {
  const auto hit = section_.enter(ray, -1);
  return hit ? temperature_(section_.project(ray.at(hit->distance))) : std::numeric_limits<double>::quiet_NaN();
}

double LineOfSight::apparent_temperature(double radiance) const {
  double low = 200, high = 3000;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (whole_.value(middle) < M_PI * radiance ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace parison::thermal
