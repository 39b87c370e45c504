// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/law/law_optimum.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace parison::contact {
namespace {

using Law = PressureViscosityConductance;
using namespace law_constant;

/// Residuals and their derivatives as Eigen's Levenberg-Marquardt asks for them.
struct Residuals : Eigen::DenseFunctor<double> {
  const std::vector<LawMeasurement>& data;
  const LawUnknowns& unknowns;
  Eigen::VectorXd weight;

  Residuals(const std::vector<LawMeasurement>& d, const LawUnknowns& u)
      : DenseFunctor(static_cast<int>(u.free.size()), static_cast<int>(d.size())), data(d), unknowns(u) {
    weight = Eigen::VectorXd::Ones(values());
  }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residual) const {
    const Law law = unknowns.law(x);
    for (std::size_t i = 0; i < data.size(); ++i)
      residual[i] =
          weight[i] * (data[i].value - data[i].drive * conductance(law, data[i].pressure, data[i].viscosity).h);
    return residual.allFinite() ? 0 : -1;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    const Law law = unknowns.law(x);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto of_h = law_derivatives(law, data[i].pressure, data[i].viscosity);
      for (std::size_t j = 0; j < unknowns.free.size(); ++j)
        jacobian(i, j) = -weight[i] * data[i].drive * of_h[unknowns.free[j]];
    }
    return 0;
  }
};

/// Laws to start from: h from below to above the data, x = 1 in their middle, all likely exponents.
std::vector<Law> starts(const std::vector<LawMeasurement>& data) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0, log_p = 0, log_eta = 0;
  int positive_pressures = 0;
  for (const auto& row : data) {
    const double h = row.value / row.drive;
    if (row.drive != 0 && h > 0) lowest = std::min(lowest, h), highest = std::max(highest, h);
    if (row.pressure > 0) log_p += std::log(row.pressure), ++positive_pressures;
    log_eta += std::log(row.viscosity) / static_cast<double>(data.size());
  }
  const double p = positive_pressures > 0 ? std::exp(log_p / positive_pressures) : 1;
  if (highest == 0) lowest = highest = 1;
  std::vector<Law> laws;
  for (const double beyond : {1.2, 5.0})
    for (const double by_p : {0.5, 1.0, 2.0})
      for (const double by_eta : {0.1, 0.4, 1.0})
        laws.push_back({lowest / beyond, highest * beyond, p, std::exp(log_eta), by_p, by_eta});
  return laws;
}

/// Moves the constant that p_ref and eta_ref make together to the one that is free, so that x = 1 stays where it was.
Law shift_reference(Law start, const Law& fixed, const std::array<bool, law_constants>& is_fixed) {
  const double log_c = start.b * std::log(start.eta_ref) - start.a * std::log(start.p_ref);
  for (int constant = 0; constant < law_constants; ++constant)
    if (is_fixed[constant]) constant_of(start, constant) = constant_of(fixed, constant);
  if (!is_fixed[eta_ref] && start.b > 0)
    start.eta_ref = std::exp((log_c + start.a * std::log(start.p_ref)) / start.b);
  else if (!is_fixed[p_ref] && start.a > 0)
    start.p_ref = std::exp((start.b * std::log(start.eta_ref) - log_c) / start.a);
  return start;
}

LawOptimum optimise(Residuals& residuals, Eigen::VectorXd x) {
  if (x.size() > 0) {
    Eigen::LevenbergMarquardt<Residuals> method(residuals);
    method.setMaxfev(400);
    method.setFtol(1e-14);
    method.setXtol(1e-12);
    method.minimize(x);
  }
  Eigen::VectorXd residual(residuals.values());
  if (!x.allFinite() || residuals(x, residual) < 0) return {};
  LawOptimum found{x, residual, Eigen::MatrixXd(residuals.values(), x.size()), residual.squaredNorm()};
  residuals.df(x, found.jacobian);
  return found;
}

LawOptimum optimise(Residuals& residuals, const LawFitOptions& options) {
  LawOptimum best;
  for (const Law& start : starts(residuals.data)) {
    auto found = optimise(residuals, residuals.unknowns.of(shift_reference(start, options.fixed, options.is_fixed)));
    if (found.squares < best.squares) best = std::move(found);
  }
  return best;
}

/// Least squares of shares of the fitted values: shares of the measured ones would favour those that came out low.
LawOptimum optimise_relative(Residuals& residuals, const LawFitOptions& options) {
  constexpr int rounds = 5;
  for (int i = 0; i < residuals.values(); ++i) residuals.weight[i] = 1 / std::abs(residuals.data[i].value);
  LawOptimum best = optimise(residuals, options);
  for (int round = 0; round < rounds && std::isfinite(best.squares); ++round) {
    const Law law = residuals.unknowns.law(best.x);
    for (int i = 0; i < residuals.values(); ++i) {
      const auto& row = residuals.data[i];
      residuals.weight[i] = 1 / std::abs(row.drive * conductance(law, row.pressure, row.viscosity).h);
    }
    best = optimise(residuals, best.x);
  }
  return best;
}

}  // namespace

Law LawUnknowns::law(const Eigen::VectorXd& x) const {
  Law result = fixed;
  for (std::size_t i = 0; i < free.size(); ++i)
    constant_of(result, free[i]) = is_exponent(free[i]) ? x[i] : std::exp(x[i]);
  return result;
}

Eigen::VectorXd LawUnknowns::of(const Law& from) const {
  Eigen::VectorXd x(free.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    x[i] = is_exponent(free[i]) ? constant_of(from, free[i]) : std::log(constant_of(from, free[i]));
  return x;
}

LawUnknowns unknowns_of(const LawFitOptions& options) {
  LawUnknowns unknowns{options.fixed, {}};
  for (int constant = 0; constant < law_constants; ++constant)
    if (!options.is_fixed[constant]) unknowns.free.push_back(constant);
  return unknowns;
}

LawOptimum find_optimum(const std::vector<LawMeasurement>& data, const LawFitOptions& options,
                        const LawUnknowns& unknowns) {
  Residuals residuals(data, unknowns);
  return options.relative ? optimise_relative(residuals, options) : optimise(residuals, options);
}

}  // namespace parison::contact
