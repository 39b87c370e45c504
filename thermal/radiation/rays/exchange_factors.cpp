// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/rays/exchange_factors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "thermal/radiation/fresnel.hpp"

namespace parison::thermal {

namespace {

constexpr double trapped = 0.1;    ///< share of the light left where a ray ends that was reflected wholly so far
constexpr int most_chords = 5000;  ///< of a ray; between two mirrors they are many
constexpr double finest = 0.5;     ///< length of a segment of a ray, of a zone's box

/// Part of a ray in one zone.
struct Segment {
  Index zone;
  double length;  ///< m
  ZoneValues values;
};

/// A few numbers by function or patch, collected along a ray.
struct Collected {
  std::vector<Index> index;
  Eigen::VectorXd value;  ///< zero but for those

  explicit Collected(Index size) : value(Eigen::VectorXd::Zero(size)), listed_(static_cast<std::size_t>(size)) {}
  void add(Index at, double x) {
    if (!listed_[static_cast<std::size_t>(at)]) index.push_back(at);
    listed_[static_cast<std::size_t>(at)] = true;
    value[at] += x;
  }
  void clear() {
    for (const Index at : index) value[at] = 0, listed_[static_cast<std::size_t>(at)] = false;
    index.clear();
  }

 private:
  std::vector<bool> listed_;  ///< also where the value has underflowed to zero since
};

/// Light of one band along a ray.
struct BandOnRay {
  Eigen::VectorXd absorption;  ///< by zone, 1/m
  double left = 1;             ///< what is left of the light since the end of the first chord
  double least = trapped;      ///< where that ends
  Collected source, sink;      ///< what the first chord and the patch send, and what takes it, of 1

  BandOnRay(Eigen::VectorXd kappa, Index size) : absorption(std::move(kappa)), source(size), sink(size) {}
};

class Tracer {
 public:
  Tracer(const core::Mesh& mesh, Geometry geometry, const Zones& zones, const std::vector<RaySurface>& surface,
         Index patches, double index, const std::vector<Eigen::VectorXd>& absorption, double end)
      : section_(mesh, geometry),
        zones_(zones),
        surface_(surface),
        index_(index),
        end_(end),
        first_patch_(zones.function_count()),
        passed_(zones.size(), Eigen::Matrix3d::Zero()) {
    for (const Eigen::VectorXd& kappa : absorption) {
      bands_.emplace_back(kappa, first_patch_ + patches);
      factors_.push_back(ExchangeFactors::Zero(first_patch_ + patches, first_patch_ + patches));
    }
  }

  /// Follows the light that starts at a point of an edge in a direction, `weight` its flux in equilibrium, W.
  void follow(Index edge, double s, double mu, double azimuth, double weight) {
    Index facet = section_.facet_at(edge, s);
    Ray ray = start(edge, s, mu, azimuth);
    begin(surface_[edge], mu);
    bool first = true;
    for (int chords = 0; chords < most_chords; ++chords) {
      const auto hit = section_.leave(ray, facet);
      if (!hit) break;
      cut(ray, hit->distance);
      for (std::size_t b = 0; b < bands_.size(); ++b)
        if (first)
          pass_first(bands_[b], factors_[b], weight);
        else
          pass(bands_[b]);
      if (first) add_passed(weight / (4 * index_ * index_));
      const RaySurface& at = surface_[hit->edge];
      const Eigen::Vector3d x = ray.at(hit->distance), normal = section_.normal(hit->edge, hit->s, x);
      if (at.patch >= 0) {
        meet(at, std::abs(normal.dot(ray.direction)));
        first = false;
        if (std::none_of(bands_.begin(), bands_.end(), [](const BandOnRay& band) { return band.left > band.least; }))
          break;
      }
      facet = hit->facet;
      ray = {x, reflected(ray.direction, normal, section_.facet_normal(facet, x))};
    }
    for (std::size_t b = 0; b < bands_.size(); ++b) finish(bands_[b], factors_[b], weight);
  }

  /// The factors, symmetric. What the places of the rays say of the volume of a zone is not quite what the mesh says;
  /// the difference counts as absorbed where it was emitted, so that no more than what is emitted is ever absorbed.
  std::vector<ExchangeFactors> result() {
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      ExchangeFactors& factors = factors_[b];
      factors = (0.5 * (factors + factors.transpose())).eval();
      for (Index z = 0; z < zones_.size(); ++z) {
        const double emission = 4 * index_ * index_ * bands_[b].absorption[z];
        factors.block<zone_functions, zone_functions>(zone_functions * z, zone_functions * z) +=
            emission * (Eigen::Matrix3d::Identity() - passed_[z]);
      }
    }
    return std::move(factors_);
  }

  const Section& section() const { return section_; }

 private:
  Ray start(Index edge, double s, double mu, double azimuth) const {
    const Eigen::Vector3d x = section_.point(edge, s), outward = section_.normal(edge, s, x);
    const Eigen::Vector3d across(0, 1, 0), along(-outward[2], 0, outward[0]);
    const double sine = std::sqrt(1 - mu * mu);
    const Eigen::Vector3d direction = -mu * outward + sine * (std::cos(azimuth) * along + std::sin(azimuth) * across);
    return {x, inward(direction, section_.facet_normal(section_.facet_at(edge, s), x))};
  }
  /// A direction that leads away from the facet: the normals of facet and edge differ a little.
  static Eigen::Vector3d inward(Eigen::Vector3d direction, const Eigen::Vector3d& facet_normal) {
    const double outward = direction.dot(facet_normal);
    if (outward > -grazing) direction -= (outward + grazing) * facet_normal;
    return direction.normalized();
  }
  static Eigen::Vector3d reflected(const Eigen::Vector3d& d, const Eigen::Vector3d& normal,
                                   const Eigen::Vector3d& facet_normal) {
    return inward(d - 2 * d.dot(normal) * normal, facet_normal);
  }
  double reflectivity(const RaySurface& at, double mu) const {
    return at.black ? 0 : fresnel_reflectivity(index_, std::min(1.0, mu));
  }

  void begin(const RaySurface& at, double mu) {
    const double entering = 1 - reflectivity(at, mu);
    for (BandOnRay& band : bands_) {
      band.left = 1;
      band.least = entering > 0 ? end_ : trapped;
      if (at.patch >= 0 && entering > 0) band.source.add(first_patch_ + at.patch, entering);
    }
  }

  void cut(const Ray& ray, double distance) {
    const int count = std::max(1, static_cast<int>(std::ceil(distance / (finest * zones_.box_size()))));
    const double length = distance / count;
    segments_.resize(count);
    for (int k = 0; k < count; ++k) {
      const Point x = section_.project(ray.at((k + 0.5) * length));
      const Index zone = zones_.at(x);
      segments_[k] = {zone, length, zones_.values(zone, x)};
    }
  }

  void add_passed(double area) {
    for (const Segment& segment : segments_) {
      const Eigen::Map<const Eigen::Vector3d> values(segment.values.data());
      passed_[segment.zone] += area * segment.length * values * values.transpose();
    }
  }

  void pass_first(BandOnRay& band, ExchangeFactors& factors, double weight) {
    for (const Segment& segment : segments_) {
      const double depth = band.absorption[segment.zone] * segment.length, transmitted = std::exp(-depth),
                   share = 1 - transmitted;
      const Index at = zone_functions * segment.zone;
      for (int i = 0; i < zone_functions; ++i) {
        const double taken = weight * share * segment.values[i];
        for (const Index from : band.source.index) factors(from, at + i) += taken * band.source.value[from];
        for (int j = 0; j < zone_functions; ++j)
          factors(at + i, at + j) += weight * (depth - share) * segment.values[i] * segment.values[j];
      }
      for (const Index from : band.source.index) band.source.value[from] *= transmitted;
      for (int i = 0; i < zone_functions; ++i) band.source.add(at + i, share * segment.values[i]);
    }
  }

  void pass(BandOnRay& band) const {
    if (band.left <= band.least) return;
    for (const Segment& segment : segments_) {
      const double transmitted = std::exp(-band.absorption[segment.zone] * segment.length);
      const double taken = band.left * (1 - transmitted);
      for (int i = 0; i < zone_functions; ++i)
        band.sink.add(zone_functions * segment.zone + i, taken * segment.values[i]);
      band.left *= transmitted;
    }
  }

  void meet(const RaySurface& at, double mu) {
    const double R = reflectivity(at, mu);
    for (BandOnRay& band : bands_) {
      if (band.left <= band.least) continue;
      if (R < 1) band.least = end_;
      if (R < 1) band.sink.add(first_patch_ + at.patch, band.left * (1 - R));
      band.left *= R;
    }
  }

  /// What is left goes where the rest went.
  static void finish(BandOnRay& band, ExchangeFactors& factors, double weight) {
    const double rest = std::max(1e-6, 1 - band.left);
    for (const Index to : band.sink.index) {
      const double taken = weight * band.sink.value[to] / rest;
      for (const Index from : band.source.index) factors(from, to) += taken * band.source.value[from];
    }
    band.source.clear();
    band.sink.clear();
  }

  Section section_;
  const Zones& zones_;
  const std::vector<RaySurface>& surface_;
  double index_;
  double end_;  ///< share of the light that is left where a ray ends
  Index first_patch_;
  std::vector<BandOnRay> bands_;
  std::vector<ExchangeFactors> factors_;
  /// By zone: products of its functions over the volume of the first chords, the identity but for their places.
  std::vector<Eigen::Matrix3d> passed_;
  std::vector<Segment> segments_;
};

}  // namespace

std::vector<ExchangeFactors> trace_exchange(const core::Mesh& mesh, Geometry geometry, const Zones& zones,
                                            const std::vector<RaySurface>& surface, Index patches, double index,
                                            const std::vector<Eigen::VectorXd>& absorption,
                                            const LightResolution& resolution) {
  Tracer tracer(mesh, geometry, zones, surface, patches, index, absorption, resolution.end());
  const bool only_mirrors = patches == 0;
  double length = 0;
  const auto starts_at = [&](std::size_t e) {
    return tracer.section().facet_at(static_cast<Index>(e), 0) >= 0 && (only_mirrors || surface[e].patch >= 0);
  };
  const auto length_of = [&](std::size_t e) {
    const auto& nodes = mesh.boundary_edges()[e].nodes;
    return (mesh.nodes[nodes[1]] - mesh.nodes[nodes[0]]).norm();
  };
  for (std::size_t e = 0; e < surface.size(); ++e)
    if (starts_at(e)) length += length_of(e);
  long k = 0;
  for (std::size_t e = 0; e < surface.size(); ++e) {
    if (!starts_at(e)) continue;
    const auto edge = static_cast<Index>(e);
    const int count = std::max(8, static_cast<int>(std::lround(resolution.rays * length_of(e) / length)));
    double exact = 0, sum = 0;
    for (const auto& at : core::edge_rule(3))
      exact += core::map_edge_point(mesh, mesh.boundary_edges()[e].nodes, geometry, at).area;
    for (int i = 0; i < count; ++i)
      sum += core::depth(geometry, {tracer.section().point(edge, (i + 0.5) / count)[0], 0});
    for (int i = 0; i < count; ++i, ++k) {
      const double s = (i + 0.5) / count;
      const auto [square, turn] = spread_place(k);
      const double area = exact * core::depth(geometry, {tracer.section().point(edge, s)[0], 0}) / sum;
      if (const int weight = resolution.part.weight(k); weight > 0)
        tracer.follow(edge, s, std::sqrt(square), M_PI * turn, weight * index * index * area);
    }
  }
  return tracer.result();
}

}  // namespace parison::thermal
