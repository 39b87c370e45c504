// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/minimum/least_squares.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Ending = LeastSquaresResult::Ending;

constexpr double first_damping = 0.03, most_damping = 1e3;
constexpr int most_updates = 5;  ///< steps between two Jacobians
/// Of the gain that was expected: where a step counts as good and as bad.
constexpr double good_gain = 0.6, bad_gain = 0.25;

/// The search while it goes on; places in steps of the variables from the start.
class Search {
 public:
  Search(VectorXd start, const LeastSquaresOptions& options, const Residuals& residuals)
      : start_(std::move(start)), options_(options), residuals_(residuals) {
    low_ = (options.low - start_).cwiseQuotient(options.step);
    high_ = (options.high - start_).cwiseQuotient(options.step);
    at_ = VectorXd::Zero(start_.size());
  }

  LeastSquaresResult find() {
    const auto first = ask({at_});
    if (first.empty()) return result(Ending::stopped);
    if (!first.front()) return result(Ending::start_failed);
    residual_ = *first.front();
    for (double before = 2 * size(residual_);;) {
      if (size(residual_) <= options_.good_enough) return result(Ending::good_enough);
      if (size(residual_) > (1 - options_.least_gain) * before) return result(Ending::no_more_gain);
      before = size(residual_);
      if (left() < std::size_t(at_.size()) + 1) return result(Ending::no_more_runs);
      if (!make_jacobian() || !descend()) return result(Ending::stopped);
    }
  }

 private:
  double size(const VectorXd& residual) const { return counted(residual, options_.limits).norm(); }

  /// Limits that the step is expected to hold take no part in it.
  VectorXd next_step() const {
    VectorXd weight = VectorXd::Ones(residual_.size());
    weight.tail(options_.limits) = (residual_.tail(options_.limits).array() > 0).cast<double>();
    VectorXd step;
    for (Index round = 0; round <= 2 * options_.limits; ++round) {
      step = bounded_step(weight.asDiagonal() * jacobian_, weight.cwiseProduct(residual_), damping_, low_ - at_,
                          high_ - at_);
      const VectorXd expected = (residual_ + jacobian_ * step).tail(options_.limits);
      VectorXd next = weight;
      next.tail(options_.limits) = (expected.array() > 0).cast<double>();
      if (next == weight) break;
      weight = next;
    }
    return step;
  }

  std::size_t left() const { return options_.runs - std::min(options_.runs, runs_); }

  /// Empty where stopped.
  std::vector<std::optional<VectorXd>> ask(const std::vector<VectorXd>& places) {
    std::vector<VectorXd> values;
    for (const VectorXd& place : places) values.push_back(start_ + place.cwiseProduct(options_.step));
    auto found = residuals_(values);
    runs_ += found.size();
    if (found.size() < places.size()) found.clear();
    return found;
  }

  /// A step aside in one variable, on its side or where the bound is in the way on the other one.
  VectorXd aside(Index variable, double side) const {
    VectorXd place = at_;
    const double room = side > 0 ? high_[variable] - at_[variable] : at_[variable] - low_[variable];
    place[variable] += room < 1 ? -side : side;
    return place.cwiseMax(low_).cwiseMin(high_);
  }

  /// Difference quotients of so many variables; those that have none are returned. Nothing where stopped.
  std::optional<std::vector<Index>> fill(const std::vector<Index>& variables, double side) {
    std::vector<VectorXd> places;
    for (const Index variable : variables) places.push_back(aside(variable, side));
    const auto found = ask(places);
    if (found.size() < places.size()) return std::nullopt;
    std::vector<Index> missing;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const double width = places[i][variables[i]] - at_[variables[i]];
      if (!found[i])
        missing.push_back(variables[i]);
      else if (width != 0)
        jacobian_.col(variables[i]) = (*found[i] - residual_) / width;
      if (found[i]) keep_if_better(places[i], *found[i]);
    }
    return missing;
  }

  /// False where stopped. A better place beside the present one is gone to only after the whole Jacobian is there.
  bool make_jacobian() {
    jacobian_ = MatrixXd::Zero(residual_.size(), at_.size());
    best_residual_ = residual_;
    best_ = at_;
    std::vector<Index> all;
    for (Index i = 0; i < at_.size(); ++i) all.push_back(i);
    const auto missing = fill(all, 1);
    if (!missing) return false;
    const std::size_t room = left() > 1 ? left() - 1 : 0;
    const std::vector<Index> again(missing->begin(), missing->begin() + long(std::min(room, missing->size())));
    return again.empty() || fill(again, -1);
  }

  void keep_if_better(const VectorXd& place, const VectorXd& residual) {
    if (size(residual) >= size(best_residual_)) return;
    best_ = place;
    best_residual_ = residual;
  }

  /// Steps from the present place until a new Jacobian is due; false where stopped.
  bool descend() {
    for (int update = 0, bad = 0; update < most_updates && bad < 2 && left() > 0 && damping_ < most_damping; ++update) {
      const VectorXd step = next_step();
      if (step.norm() < 1e-3) break;
      const auto found = ask({at_ + step});
      if (found.empty()) return false;
      if (!found.front()) {
        damping_ *= 8;
        ++bad;
        continue;
      }
      bad += take(step, *found.front()) ? 0 : 1;
      if (size(residual_) <= options_.good_enough) break;
    }
    if (size(best_residual_) < size(residual_)) {
      at_ = best_;
      residual_ = best_residual_;
    }
    damping_ = std::min(damping_, 1.0);
    return true;
  }

  /// Learns from a run and goes there where it is better; whether it gained what counts.
  bool take(const VectorXd& step, const VectorXd& found) {
    const VectorXd expected = residual_ + jacobian_ * step;
    const double before = std::pow(size(residual_), 2), gain = before - std::pow(size(found), 2);
    const double share = gain / std::max(before - std::pow(size(expected), 2), 1e-300);
    jacobian_ += (found - expected) * step.transpose() / step.squaredNorm();
    if (share > good_gain) damping_ /= 3;
    if (share < bad_gain) damping_ *= 4;
    if (gain > 0) {
      at_ += step;
      residual_ = found;
    }
    return gain > 2 * options_.least_gain * before;
  }

  LeastSquaresResult result(Ending ending) const {
    LeastSquaresResult found{start_ + at_.cwiseProduct(options_.step), residual_, jacobian_, runs_, ending};
    for (Index i = 0; i < found.jacobian.cols(); ++i) found.jacobian.col(i) /= options_.step[i];
    return found;
  }

  VectorXd start_, low_, high_, at_, residual_, best_, best_residual_;
  const LeastSquaresOptions& options_;
  const Residuals& residuals_;
  MatrixXd jacobian_;
  double damping_ = first_damping;
  std::size_t runs_ = 0;
};

}  // namespace

LeastSquaresResult least_squares(const VectorXd& start, const LeastSquaresOptions& options,
                                 const Residuals& residuals) {
  return Search(start, options, residuals).find();
}

VectorXd counted(VectorXd residual, Index limits) {
  residual.tail(limits) = residual.tail(limits).cwiseMax(0);
  return residual;
}

VectorXd bounded_step(const MatrixXd& jacobian, const VectorXd& residual, double damping, const VectorXd& low,
                      const VectorXd& high) {
  const Index count = jacobian.cols();
  const MatrixXd square = jacobian.transpose() * jacobian;
  const double scale = std::max(square.diagonal().mean(), 1e-300);
  const MatrixXd damped = square + damping * scale * MatrixXd::Identity(count, count);
  VectorXd step = VectorXd::Zero(count);
  std::vector<bool> is_held(std::size_t(count), false);
  for (Index round = 0; round <= count; ++round) {
    std::vector<Index> free;
    VectorXd held = VectorXd::Zero(count);
    for (Index i = 0; i < count; ++i)
      if (is_held[std::size_t(i)])
        held[i] = step[i];
      else
        free.push_back(i);
    if (free.empty()) return step;
    const VectorXd right = -(jacobian.transpose() * residual) - square * held;
    const VectorXd part = MatrixXd(damped(free, free)).ldlt().solve(VectorXd(right(free)));
    bool beyond = false;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const Index i = free[k];
      const double wanted = part[Index(k)];
      step[i] = std::clamp(wanted, low[i], high[i]);
      if (step[i] != wanted) is_held[std::size_t(i)] = beyond = true;
    }
    if (!beyond) return step;
  }
  return step;
}

}  // namespace parison::forming
