// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/settled_estimates.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "forming/study/production/tool_fields.hpp"

namespace parison::forming {
namespace {

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

void SettledEstimates::add(const Eigen::VectorXd& start, const Eigen::VectorXd& end, const Eigen::VectorXd& settled) {
  runs_.push_back({settled, surface_changes(tools_, end - start), surface_changes(tools_, settled - start)});
}

int SettledEstimates::repeated() const {
  constexpr double falls = 0.5;
  int count = 0;
  double later = 0;  // sum of the distances of the runs after this one
  for (int last = static_cast<int>(runs_.size()), k = last - 1; k >= 0; --k) {
    const double distance = largest(runs_[k].distance);
    if (later > 0 && falls * distance <= later / (last - 1 - k) && largest(runs_[k].change) <= tolerance_)
      count = last - k;
    later += distance;
  }
  return std::max(count, runs_.empty() ? 0 : 1);
}

Eigen::VectorXd SettledEstimates::mean() const {
  const int count = repeated();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(runs_.back().settled.size());
  for (auto run = runs_.end() - count; run != runs_.end(); ++run) sum += run->settled;
  return sum / count;
}

double SettledEstimates::uncertainty() const {
  const int count = repeated();
  if (count > 1) {
    const Eigen::VectorXd middle = mean();
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(middle.size());
    for (auto run = runs_.end() - count; run != runs_.end(); ++run) squares += (run->settled - middle).cwiseAbs2();
    const double t = quantile(boost::math::students_t(count - 1), 0.95);
    return t * surface_change(tools_, (squares / (count - 1.0) / count).cwiseSqrt());
  }
  const double change = largest(runs_.back().change), distance = largest(runs_.back().distance);
  if (runs_.size() == 1) return std::max(change, 2 * distance);
  const double ratio = distance / largest(runs_[runs_.size() - 2].distance);
  return std::max(change, ratio < 0.5 ? 2 * distance * ratio / (1 - ratio) : 2 * distance);
}

}  // namespace parison::forming
