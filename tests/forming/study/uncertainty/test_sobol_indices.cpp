// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "forming/study/sweep/design.hpp"
#include "forming/study/uncertainty/effects.hpp"

namespace parison::forming {
namespace {

using Eigen::Index;

constexpr double pi = 3.14159265358979323846;

/// A function of uniform shares with known indices.
struct Known {
  std::function<double(const std::vector<double>&)> value;
  std::vector<double> first, total;
  double variance;
};

/// T. Ishigami, T. Homma, Proc. ISUMA (1990) 398-403, with a = 7, b = 0.1.
Known ishigami() {
  const double a = 7, b = 0.1, p4 = std::pow(pi, 4);
  const double v1 = 0.5 * std::pow(1 + b * p4 / 5, 2), v2 = a * a / 8, v13 = b * b * p4 * p4 * (1.0 / 18 - 1.0 / 50);
  const double v = v1 + v2 + v13;
  return {[=](const std::vector<double>& u) {
            const auto x = [&](std::size_t i) { return pi * (2 * u[i] - 1); };
            return std::sin(x(0)) + a * std::pow(std::sin(x(1)), 2) + b * std::pow(x(2), 4) * std::sin(x(0));
          },
          {v1 / v, v2 / v, 0},
          {(v1 + v13) / v, v2 / v, v13 / v},
          v};
}

/// The g-function (I. M. Sobol, Math. Comput. Simul. 55 (2001) 271-280): product of (|4u - 2| + a)/(1 + a).
Known g_function(const std::vector<double>& a) {
  Known known;
  known.value = [a](const std::vector<double>& u) {
    double product = 1;
    for (std::size_t i = 0; i < a.size(); ++i) product *= (std::abs(4 * u[i] - 2) + a[i]) / (1 + a[i]);
    return product;
  };
  double whole = 1;
  const auto part = [&](std::size_t i) { return 1 / (3 * (1 + a[i]) * (1 + a[i])); };
  for (std::size_t i = 0; i < a.size(); ++i) whole *= 1 + part(i);
  known.variance = whole - 1;
  for (std::size_t i = 0; i < a.size(); ++i) {
    known.first.push_back(part(i) / known.variance);
    known.total.push_back(part(i) * whole / (1 + part(i)) / known.variance);
  }
  return known;
}

/// A product of normal variables with means: x1 (2 + x2) + 0.5 x3, variances by hand.
Known normal_product() {
  return {nullptr, {4 / 5.25, 0, 0.25 / 5.25}, {5 / 5.25, 1 / 5.25, 0.25 / 5.25}, 5.25};
}

struct Coverage {
  int inside = 0, all = 0;
  double width = 0, q2 = 0;
  double share() const { return double(inside) / all; }
};

void count(const std::vector<Interval>& found, const std::vector<double>& known, Coverage& coverage) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    coverage.inside += found[i].low - 1e-9 <= known[i] && known[i] <= found[i].high + 1e-9;
    coverage.width += found[i].high - found[i].low;
    ++coverage.all;
  }
}

/// Normal deviates by the Box-Muller transform, the same on every machine.
double normal(std::mt19937_64& engine) {
  const auto share = [&] { return (double(engine() >> 11) + 0.5) / double(std::uint64_t{1} << 53); };
  const double radius = std::sqrt(-2 * std::log(share()));
  return radius * std::cos(2 * pi * share());
}

/// How often the known indices lie inside their intervals, over many designs. `noise` is the standard deviation of what
/// is added to each run, in those of the function; the analysis knows its variance as a lower limit.
Coverage repeat(const Known& known, core::Distribution distribution, std::size_t runs, int repetitions, double noise) {
  const std::vector<StandardScatter> scatters(known.first.size(), full_range(distribution));
  Coverage coverage;
  for (int repetition = 1; repetition <= repetitions; ++repetition) {
    const auto shares = sobol_sequence(scatters.size(), runs, std::uint64_t(repetition));
    std::mt19937_64 engine(std::uint64_t(1000 + repetition));
    Eigen::MatrixXd places(Index(runs), Index(scatters.size()));
    Eigen::VectorXd values{Index(runs)};
    std::vector<Index> rows;
    const double deviation = noise * std::sqrt(known.variance);
    for (Index run = 0; run < Index(runs); ++run) {
      for (Index i = 0; i < places.cols(); ++i)
        places(run, i) = quantile(scatters[std::size_t(i)], shares[std::size_t(run)][std::size_t(i)]);
      const double exact = known.value ? known.value(shares[std::size_t(run)])
                                       : places(run, 0) * (2 + places(run, 1)) + 0.5 * places(run, 2);
      values[run] = exact + deviation * normal(engine);
      rows.push_back(run);
    }
    const Effects effects = find_effects(chaos_basis(scatters, places), scatters, rows, values,
                                         deviation * deviation / 2, std::uint64_t(repetition));
    const SobolIndices found = sobol_indices(effects);
    count(found.first, known.first, coverage);
    count(found.total, known.total, coverage);
    coverage.q2 += effects.q2() / repetitions;
  }
  coverage.width /= coverage.all;
  std::printf("inside %.3f, mean width %.3f, mean Q2 %.3f\n", coverage.share(), coverage.width, coverage.q2);
  return coverage;
}

TEST(SobolIndices, OfIshigamiLieInTheirIntervalsInNineOfTen) {
  const Coverage coverage = repeat(ishigami(), core::Distribution::uniform, 120, 40, 0);
  EXPECT_GE(coverage.share(), 0.9);
  EXPECT_LT(coverage.width, 0.1);
}

TEST(SobolIndices, OfTheGFunctionLieInTheirIntervalsInNineOfTen) {
  const Coverage coverage = repeat(g_function({0, 1, 4.5, 9}), core::Distribution::uniform, 120, 40, 0);
  EXPECT_GE(coverage.share(), 0.9);
  EXPECT_LT(coverage.width, 0.1);
}

TEST(SobolIndices, OfNormalTolerancesLieInTheirIntervalsInNineOfTen) {
  const Coverage coverage = repeat(normal_product(), core::Distribution::normal, 40, 60, 0.1);
  EXPECT_GE(coverage.share(), 0.9);
  EXPECT_LT(coverage.width, 0.15);
}

TEST(SobolIndices, WithNoisyRunsLieInTheirIntervalsInNineOfTen) {
  const Coverage ishigami_runs = repeat(ishigami(), core::Distribution::uniform, 160, 30, 0.2);
  EXPECT_GE(ishigami_runs.share(), 0.9);
  EXPECT_LT(ishigami_runs.width, 0.25);
  EXPECT_GE(repeat(g_function({0, 1, 4.5, 9}), core::Distribution::uniform, 120, 30, 0.3).share(), 0.9);
}

TEST(SobolIndices, WithFewRunsAreWideAndStillRight) {
  const Coverage coverage = repeat(ishigami(), core::Distribution::uniform, 30, 40, 0);
  EXPECT_GE(coverage.share(), 0.9);
  EXPECT_LT(coverage.q2, 0.7);
}

TEST(SobolIndices, OfNoiseAloneAreUnknownAndItIsNoEffect) {
  const std::vector<StandardScatter> scatters(3, full_range(core::Distribution::normal));
  int with_effect = 0;
  double mean = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto shares = sobol_sequence(3, 48, seed);
    std::mt19937_64 engine(seed);
    Eigen::MatrixXd places(48, 3);
    Eigen::VectorXd values(48);
    std::vector<Index> rows;
    for (Index run = 0; run < 48; ++run) {
      for (Index i = 0; i < 3; ++i) places(run, i) = quantile(scatters[0], shares[std::size_t(run)][std::size_t(i)]);
      values[run] = normal(engine);
      rows.push_back(run);
    }
    const Effects effects = find_effects(chaos_basis(scatters, places), scatters, rows, values, 1, seed);
    with_effect += has_effect(effects);
    mean += std::max(0.0, effects.found.whole) / 40;
    EXPECT_LT(effects.q2(), 0.3) << seed;
  }
  std::printf("%d of 40 found an effect; mean variance %.3f\n", with_effect, mean);
  EXPECT_LE(with_effect, 2);
  EXPECT_LT(mean, 0.1);
}

}  // namespace
}  // namespace parison::forming
