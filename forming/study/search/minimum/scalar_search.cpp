// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/minimum/scalar_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace parison::forming {
namespace {

/// The search ends when its simplex has become this share of the steps: finer is below the noise of a run.
constexpr double finest_share = 0.15;

/// What NLopt's functions of C reach the runs by; the value and its limits are asked for one after the other, so the
/// last place is kept.
struct Asked {
  const ScalarOptions& options;
  const std::function<std::optional<ScalarValue>(const Eigen::VectorXd&)>& ask;
  const std::function<bool()>& stopped;
  nlopt_opt search = nullptr;
  Eigen::VectorXd at = {};
  ScalarValue last = {};
  double worst = 0;
  bool has_worst = false, is_good = false;
};

/// In place of a run that failed: worse than any seen, with all limits missed.
ScalarValue failed_value(const Asked& asked) {
  const double size = std::max(std::abs(asked.worst), 1.0);
  return {asked.has_worst ? asked.worst + 0.1 * size : size,
          Eigen::VectorXd::Constant(Eigen::Index(asked.options.limits), 0.1)};
}

const ScalarValue& value_at(Asked& asked, const double* x) {
  const Eigen::Index count = asked.options.step.size();
  const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(x, count).cwiseProduct(asked.options.step);
  if (asked.at.size() == count && asked.at == at) return asked.last;
  if (asked.stopped()) {
    nlopt_force_stop(asked.search);
    return asked.last = failed_value(asked);
  }
  const auto found = asked.ask(at);
  asked.at = at;
  asked.last = found ? *found : failed_value(asked);
  if (found) asked.worst = asked.has_worst ? std::max(asked.worst, found->value) : found->value;
  asked.has_worst = asked.has_worst || found.has_value();
  asked.is_good =
      asked.is_good || (found && found->value <= asked.options.good_enough && (found->excess.array() <= 0).all());
  if (asked.is_good || asked.stopped()) nlopt_force_stop(asked.search);
  return asked.last;
}

double objective(unsigned, const double* x, double*, void* asked) {
  return value_at(*static_cast<Asked*>(asked), x).value;
}

void limits(unsigned count, double* result, unsigned, const double* x, double*, void* asked) {
  const ScalarValue& value = value_at(*static_cast<Asked*>(asked), x);
  for (unsigned i = 0; i < count; ++i) result[i] = value.excess[Eigen::Index(i)];
}

}  // namespace

ScalarEnding scalar_search(const Eigen::VectorXd& start, const ScalarOptions& options,
                           const std::function<std::optional<ScalarValue>(const Eigen::VectorXd&)>& ask,
                           const std::function<bool()>& stopped) {
  const auto count = static_cast<unsigned>(start.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> search(nlopt_create(NLOPT_LN_COBYLA, count), nlopt_destroy);
  Asked asked{options, ask, stopped, search.get()};
  const Eigen::VectorXd low = options.low.cwiseQuotient(options.step), high = options.high.cwiseQuotient(options.step);
  Eigen::VectorXd at = start.cwiseQuotient(options.step).cwiseMax(low).cwiseMin(high);
  nlopt_set_lower_bounds(search.get(), low.data());
  nlopt_set_upper_bounds(search.get(), high.data());
  nlopt_set_min_objective(search.get(), objective, &asked);
  if (options.limits > 0)
    nlopt_add_inequality_mconstraint(search.get(), static_cast<unsigned>(options.limits), limits, &asked, nullptr);
  nlopt_set_initial_step1(search.get(), 1);
  nlopt_set_xtol_abs1(search.get(), finest_share);
  nlopt_set_maxeval(search.get(), static_cast<int>(options.runs));
  double least = 0;
  const nlopt_result ending = nlopt_optimize(search.get(), at.data(), &least);
  if (asked.is_good) return ScalarEnding::good_enough;
  if (ending == NLOPT_FORCED_STOP) return ScalarEnding::stopped;
  return ending == NLOPT_MAXEVAL_REACHED ? ScalarEnding::no_more_runs : ScalarEnding::converged;
}

}  // namespace parison::forming
