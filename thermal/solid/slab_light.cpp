// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/slab_light.hpp"

#include <Eigen/LU>
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

SlabLight::SlabLight(double refractive_index) : square_(refractive_index * refractive_index) {
  // The intensity of e is e/(4 pi), so that a direction counts with 2 pi mu dmu/(4 pi). Outside of the cone of total
  // reflection mu = critical + (1 - critical) s^2 makes the reflectivity smooth.
  const double critical = critical_cosine(refractive_index), rest = 1 - critical;
  const auto& rule = core::edge_rule(5);
  for (const auto& at : rule)
    if (critical > 0) directions_.push_back({critical * at.s, 0.5 * critical * at.s * critical * at.weight, 1});
  for (const auto& at : rule) {
    const double mu = critical + rest * at.s * at.s;
    directions_.push_back({mu, 0.5 * mu * 2 * rest * at.s * at.weight, fresnel_reflectivity(refractive_index, mu)});
  }
}

SlabExchange SlabLight::exchange(const std::vector<SlabLayer>& layers, const std::vector<double>& absorption) const {
  const auto size = static_cast<Eigen::Index>(count * layers.size());
  SlabExchange made{Eigen::MatrixXd::Zero(size, size), Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(size, 2)};
  std::vector<double> depth(layers.size());
  for (const Direction& along : directions_) {
    for (std::size_t c = 0; c < depth.size(); ++c) depth[c] = layers[c].thickness * absorption[c] / along.cosine;
    const Beam beam = add_direct(layers, depth, along.weight, made.between);
    const double r = along.reflected, back = r * beam.through, all = along.weight / (1 - back * back);
    const Eigen::VectorXd to_first = beam.first + back * beam.last, to_last = beam.last + back * beam.first;
    made.between.triangularView<Eigen::Lower>() +=
        all * r * (beam.first * to_first.transpose() + beam.last * to_last.transpose());
    made.through.col(0) += all * (1 - r) * to_first;
    made.through.col(1) += all * (1 - r) * to_last;
    made.sides(0, 1) += all * (1 - r) * (1 - r) * beam.through;
  }
  made.between.triangularView<Eigen::StrictlyUpper>() = made.between.transpose();
  made.sides(1, 0) = made.sides(0, 1);
  for (int b = 0; b < 2; ++b) made.sides(b, b) = 0.25 / square_ - made.through.col(b).sum() - made.sides(0, 1);
  return made;
}

}  // namespace parison::thermal
