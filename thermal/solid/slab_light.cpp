// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/slab_light.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::thermal {

namespace {

constexpr int count = SlabLayer::places, powers = SlabLayer::powers;

using Parabolas = Eigen::Matrix<double, 1, count>;

/// Values at x of the parabolas through the places.
Parabolas parabolas(const std::array<double, count>& at, double x) {
  Parabolas value;
  for (int i = 0; i < count; ++i) {
    value[i] = 1;
    for (int j = 0; j < count; ++j)
      if (j != i) value[i] *= (x - at[j]) / (at[i] - at[j]);
  }
  return value;
}

/// Takes the values of polynomials at even distances from 0 to 1 to their coefficients.
const Eigen::Matrix<double, powers, powers>& coefficients() {
  static const Eigen::Matrix<double, powers, powers> inverse = [] {
    Eigen::Matrix<double, powers, powers> vandermonde;
    for (int p = 0; p < powers; ++p)
      for (int k = 0; k < powers; ++k) vandermonde(p, k) = std::pow(p / (powers - 1.0), k);
    return Eigen::Matrix<double, powers, powers>(vandermonde.inverse());
  }();
  return inverse;
}

/// int u^k exp(-t u) du over 0 to 1, by k. The recursion is stable upwards for large t, downwards for small.
Eigen::Matrix<double, powers, 1> moments(double t) {
  Eigen::Matrix<double, powers, 1> m;
  const double end = std::exp(-t);
  constexpr double large = 6;
  if (t > large) {
    m[0] = (1 - end) / t;
    for (int k = 1; k < powers; ++k) m[k] = (k * m[k - 1] - end) / t;
    return m;
  }
  double term = end / powers, sum = term;
  for (int j = 1; term > 1e-17 * sum; ++j) sum += term *= t / (powers + j);
  m[powers - 1] = sum;
  for (int k = powers - 1; k > 0; --k) m[k - 1] = (t * m[k] + end) / k;
  return m;
}

/// Along one direction: what places absorb of light that enters through either side, and what gets through.
struct Beam {
  Eigen::VectorXd first, last;
  double through;
};

/// Adds what layers send each other without any reflection.
Beam add_direct(const std::vector<SlabLayer>& slab, const std::vector<double>& depth, double weight,
                Eigen::MatrixXd& between) {
  const auto layers = static_cast<int>(depth.size());
  Beam beam{Eigen::VectorXd(count * layers), Eigen::VectorXd(count * layers), 1};
  std::vector<Eigen::Vector3d> from_first(depth.size()), from_last(depth.size());
  std::vector<double> passes(depth.size());
  Eigen::Vector3d sent;
  for (int c = 0; c < layers; ++c) {
    const double t = depth[c];
    const auto moment = moments(t);
    passes[c] = std::exp(-t);
    from_first[c] = t * slab[c].first * moment;
    from_last[c] = t * slab[c].last * moment;
    const Eigen::Matrix<double, count * count, 1> own = weight * t * t * slab[c].own * moment;
    between.block<count, count>(count * c, count * c) += Eigen::Map<const Eigen::Matrix3d>(own.data());
    beam.first.segment<count>(count * c) = beam.through * from_first[c];
    beam.through *= passes[c];
    double passed = 1;
    for (int b = c - 1; b >= 0; --b) {
      sent = weight * passed * from_last[b];
      between.block<count, count>(count * c, count * b).noalias() += from_first[c] * sent.transpose();
      passed *= passes[b];
    }
  }
  double passed = 1;
  for (int c = layers - 1; c >= 0; --c) {
    beam.last.segment<count>(count * c) = passed * from_last[c];
    passed *= passes[c];
  }
  return beam;
}

}  // namespace

SlabLayer::SlabLayer(double of_thickness, const std::array<double, places>& at) : thickness(of_thickness), weight{} {
  Eigen::Matrix<double, powers, count> at_first, at_last;
  Eigen::Matrix<double, powers, count* count> at_own = Eigen::Matrix<double, powers, count * count>::Zero();
  for (int p = 0; p < powers; ++p) {
    const double u = p / (powers - 1.0);
    at_first.row(p) = parabolas(at, u);
    at_last.row(p) = parabolas(at, 1 - u);
    for (const auto& y : core::edge_rule(count)) {
      const Parabolas near = parabolas(at, (1 - u) * y.s), far = parabolas(at, (1 - u) * y.s + u);
      for (int i = 0; i < count; ++i) {
        if (p == 0) weight[i] += y.weight * near[i];
        for (int j = 0; j < count; ++j)
          at_own(p, i * count + j) += (1 - u) * y.weight * (near[i] * far[j] + far[i] * near[j]);
      }
    }
  }
  first = (coefficients() * at_first).transpose();
  last = (coefficients() * at_last).transpose();
  own = (coefficients() * at_own).transpose();
}

namespace {

/// Rays with one product of area and squared sine.
struct Ray {
  double invariant, weight;  ///< m2
  std::array<double, 2> reflected;
};

/// Rays between two of their invariants. Reflectivity and cosine go like a root at the upper one, which the square of s
/// makes smooth.
void add_rays(double from, double to, double n, const Eigen::Vector2d& area, std::vector<Ray>& rays) {
  constexpr double narrow = 0.1;
  if (!(to > from * (1 + 1e-12))) return;
  for (const auto& at : core::edge_rule(to - from < narrow * area.maxCoeff() ? 2 : 5)) {
    Ray ray{to - (to - from) * at.s * at.s, 0, {}};
    // The intensity of e is e/(4 pi): a direction counts with the area times 2 pi mu dmu/(4 pi), a quarter of the
    // change of the invariant.
    ray.weight = 0.25 * (to - from) * 2 * at.s * at.weight;
    for (int b = 0; b < 2; ++b)
      ray.reflected[b] = ray.invariant < area[b] ? fresnel_reflectivity(n, std::sqrt(1 - ray.invariant / area[b])) : 1;
    rays.push_back(ray);
  }
}

std::vector<Ray> rays_of(double n, const Eigen::Vector2d& area) {
  const double small = area.minCoeff(), large = area.maxCoeff();
  std::array<double, 5> ends{0, small / (n * n), large / (n * n), small, large};
  std::sort(ends.begin(), ends.end());
  std::vector<Ray> rays;
  for (std::size_t i = 1; i < ends.size(); ++i) add_rays(ends[i - 1], ends[i], n, area, rays);
  return rays;
}

/// Mean of 1/mu of a ray over a layer between two roots of areas; 0 where the ray does not come.
double mean_slope(double r, double s, double invariant) {
  const double mean = 0.5 * (r + s);
  if (std::abs(s - r) < 1e-7 * mean) return invariant < r * s ? mean / std::sqrt(mean * mean - invariant) : 0;
  const auto way = [&](double at) { return std::sqrt(std::max(0.0, at * at - invariant)); };
  return (way(s) - way(r)) / (s - r);
}

/// By ray and layer: 1/mu, with which each layer emits in all directions together exactly what it does.
Eigen::MatrixXd slopes_of(const std::vector<Ray>& rays, const std::vector<double>& radii) {
  Eigen::MatrixXd slopes(rays.size(), radii.size() - 1);
  for (Eigen::Index c = 0; c < slopes.cols(); ++c) {
    double all = 0;
    for (Eigen::Index k = 0; k < slopes.rows(); ++k) {
      slopes(k, c) = mean_slope(radii[c], radii[c + 1], rays[k].invariant);
      all += 2 * rays[k].weight * slopes(k, c);
    }
    slopes.col(c) *= mean_area(radii[c], radii[c + 1]) / all;
  }
  return slopes;
}

void add_ray(const Ray& ray, const Beam& beam, SlabExchange& made) {
  const auto& [first, last] = ray.reflected;
  const double lost = 1 - first * last * beam.through * beam.through;
  if (!(lost > 0)) return;  // it comes into no layer: both of its sides are nearly as large as its invariant
  const double all = ray.weight / lost;
  const Eigen::VectorXd to_first = beam.first + last * beam.through * beam.last,
                        to_last = beam.last + first * beam.through * beam.first;
  made.between.triangularView<Eigen::Lower>() +=
      all * (first * beam.first * to_first.transpose() + last * beam.last * to_last.transpose());
  made.through.col(0) += all * (1 - first) * to_first;
  made.through.col(1) += all * (1 - last) * to_last;
  made.sides(0, 1) += all * (1 - first) * (1 - last) * beam.through;
}

}  // namespace

std::vector<double> shell_radii(const std::vector<double>& volume, const Eigen::Vector2d& area) {
  const double first = std::pow(area[0], 1.5), last = std::pow(area[1], 1.5);
  double all = 0, before = 0;
  for (const double of_layer : volume) all += of_layer;
  std::vector<double> radii{std::sqrt(area[0])};
  for (const double of_layer : volume) {
    before += of_layer;
    radii.push_back(std::cbrt(first + before / all * (last - first)));
  }
  return radii;
}

SlabExchange SlabLight::exchange(const std::vector<SlabLayer>& layers, const std::vector<double>& absorption,
                                 const Eigen::Vector2d& area) const {
  const auto size = static_cast<Eigen::Index>(count * layers.size());
  SlabExchange made{Eigen::MatrixXd::Zero(size, size), Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(size, 2)};
  double all = 0, at = 0;
  for (const SlabLayer& layer : layers) all += layer.thickness;
  std::vector<double> depth(layers.size()), radii{std::sqrt(area[0])};
  for (const SlabLayer& layer : layers)
    radii.push_back(radii.front() + (at += layer.thickness) / all * (std::sqrt(area[1]) - radii.front()));
  const std::vector<Ray> rays = rays_of(index_, area);
  const Eigen::MatrixXd slopes = slopes_of(rays, radii);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    for (std::size_t c = 0; c < depth.size(); ++c)
      depth[c] =
          layers[c].thickness * absorption[c] * slopes(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c));
    add_ray(rays[k], add_direct(layers, depth, rays[k].weight, made.between), made);
  }
  made.between.triangularView<Eigen::StrictlyUpper>() = made.between.transpose();
  made.sides(1, 0) = made.sides(0, 1);
  for (int b = 0; b < 2; ++b)
    made.sides(b, b) = 0.25 * area[b] / (index_ * index_) - made.through.col(b).sum() - made.sides(0, 1);
  return made;
}

}  // namespace parison::thermal
