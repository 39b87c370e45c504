// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/case_error.hpp"
#include "forming/study/uncertainty/effects.hpp"
#include "forming/study/uncertainty/uncertainty_plan.hpp"

namespace parison::forming {
namespace {

using core::Distribution;

const StandardScatter scatters[] = {full_range(Distribution::normal),
                                    full_range(Distribution::uniform),
                                    {Distribution::normal, -0.5, 4},
                                    {Distribution::uniform, -0.3, 1.2}};

TEST(StandardScatter, HasOrthonormalPolynomialsWhereverItIsCutOff) {
  constexpr int degrees = 8, points = 20000;
  for (const StandardScatter& scatter : scatters) {
    const OrthonormalPolynomials polynomials(scatter, degrees);
    double product[degrees + 1][degrees + 1] = {}, whole = 0;
    for (int k = 0; k < points; ++k) {
      const double at = scatter.low + (scatter.high - scatter.low) * (k + 0.5) / points;
      const double weight = scatter.distribution == Distribution::uniform ? 1 : std::exp(-0.5 * at * at);
      const std::vector<double> values = polynomials(at);
      whole += weight;
      for (std::size_t i = 0; i <= degrees; ++i)
        for (std::size_t j = 0; j <= degrees; ++j) product[i][j] += weight * values[i] * values[j];
    }
    for (int i = 0; i <= degrees; ++i)
      for (int j = 0; j <= degrees; ++j) EXPECT_NEAR(product[i][j] / whole, i == j, 1e-4) << i << ' ' << j;
  }
}

TEST(StandardScatter, HasTheQuantilesOfItsShares) {
  EXPECT_NEAR(quantile(scatters[0], 0.5), 0, 1e-9);
  EXPECT_NEAR(quantile(scatters[0], 0.8413447), 1, 2e-4);
  EXPECT_NEAR(quantile(scatters[1], 0.75), 0.5 * std::sqrt(3.0), 1e-12);
  for (const StandardScatter& scatter : scatters) {
    EXPECT_DOUBLE_EQ(quantile(scatter, 0), scatter.low);
    for (int i = 0; i < 64; ++i) {
      EXPECT_LT(quantile(scatter, i / 64.0), quantile(scatter, (i + 1) / 64.0));
      EXPECT_LE(quantile(scatter, (i + 1) / 64.0), scatter.high);
    }
  }
}

const core::Tolerance tolerance{"tool.blank.temperature", "460 +- 10 degC", 460, 10, "degC", Distribution::normal};

TEST(ToleranceRange, EndsWhereTheCaseRefusesTheValue) {
  const ToleranceRange range =
      allowed_range(tolerance, [](double value) { return value < 455 ? std::string("too cold") : std::string(); });
  EXPECT_NEAR(value_at(tolerance, range.scatter.low), 455, 0.01);
  EXPECT_GE(value_at(tolerance, range.scatter.low), 455);
  EXPECT_EQ(range.below, "too cold");
  EXPECT_EQ(range.scatter.high, 4);
  EXPECT_TRUE(range.above.empty());
}

TEST(ToleranceRange, OfAMeanThatIsRefusedIsASentence) {
  try {
    allowed_range(tolerance, [](double) { return std::string("too hot"); });
    ADD_FAILURE();
  } catch (const core::CaseError& error) {
    EXPECT_STREQ(error.what(), "too hot");
  }
}

}  // namespace
}  // namespace parison::forming
