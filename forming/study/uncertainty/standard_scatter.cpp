// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/uncertainty/standard_scatter.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace parison::forming {
namespace {

using core::Distribution;

constexpr int rule_points = 4000;

/// Midpoints of the range with weights of sum 1.
struct Rule {
  std::vector<double> place, weight;
};

Rule midpoint_rule(const StandardScatter& scatter) {
  Rule rule;
  double sum = 0;
  for (int i = 0; i < rule_points; ++i) {
    const double at = scatter.low + (scatter.high - scatter.low) * (i + 0.5) / rule_points;
    rule.place.push_back(at);
    rule.weight.push_back(scatter.distribution == Distribution::uniform ? 1.0 : std::exp(-0.5 * at * at));
    sum += rule.weight.back();
  }
  for (double& weight : rule.weight) weight /= sum;
  return rule;
}

}  // namespace

StandardScatter full_range(Distribution distribution) {
  const double end = distribution == Distribution::uniform ? std::sqrt(3.0) : 4;
  return {distribution, -end, end};
}

double quantile(const StandardScatter& scatter, double share) {
  if (scatter.distribution == Distribution::uniform)
    return std::min(scatter.high, scatter.low + share * (scatter.high - scatter.low));
  const boost::math::normal normal;
  const double below = cdf(normal, scatter.low), within = cdf(normal, scatter.high) - below;
  if (share <= 0) return scatter.low;
  return std::min(scatter.high, std::max(scatter.low, boost::math::quantile(normal, below + share * within)));
}

OrthonormalPolynomials::OrthonormalPolynomials(const StandardScatter& scatter, int highest_degree) {
  const Rule rule = midpoint_rule(scatter);
  std::vector<double> before(rule.place.size(), 0), now(rule.place.size(), 1);
  for (int degree = 0; degree <= highest_degree; ++degree) {
    double alpha = 0, norm = 0;
    for (std::size_t i = 0; i < now.size(); ++i) alpha += rule.weight[i] * rule.place[i] * now[i] * now[i];
    std::vector<double> next(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
      next[i] = (rule.place[i] - alpha) * now[i] - (degree > 0 ? root_beta_.back() * before[i] : 0);
      norm += rule.weight[i] * next[i] * next[i];
    }
    alpha_.push_back(alpha);
    root_beta_.push_back(std::sqrt(norm));
    for (double& value : next) value /= root_beta_.back();
    before = std::move(now);
    now = std::move(next);
  }
}

std::vector<double> OrthonormalPolynomials::operator()(double at) const {
  std::vector<double> values{1};
  for (std::size_t degree = 0; degree + 1 < alpha_.size(); ++degree) {
    const double before = degree > 0 ? root_beta_[degree - 1] * values[degree - 1] : 0;
    values.push_back(((at - alpha_[degree]) * values[degree] - before) / root_beta_[degree]);
  }
  return values;
}

}  // namespace parison::forming
