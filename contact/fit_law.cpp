// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/fit_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <Eigen/SVD>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/LevenbergMarquardt>

#include "core/case_error.hpp"

namespace parison::contact {
namespace {

using Law = PressureViscosityConductance;
using namespace law_constant;

bool is_exponent(int constant) { return constant == a || constant == b; }

/// The free constants as the fit sees them: logarithms, but the exponents themselves.
struct Unknowns {
  Law law;  ///< with the held constants
  std::vector<int> free;

  Law at(const Eigen::VectorXd& x) const {
    Law result = law;
    for (std::size_t i = 0; i < free.size(); ++i)
      constant_of(result, free[i]) = is_exponent(free[i]) ? x[i] : std::exp(x[i]);
    return result;
  }
  Eigen::VectorXd of(const Law& from) const {
    Eigen::VectorXd x(free.size());
    for (std::size_t i = 0; i < free.size(); ++i)
      x[i] = is_exponent(free[i]) ? constant_of(from, free[i]) : std::log(constant_of(from, free[i]));
    return x;
  }
};

/// Residuals and their slopes as Eigen's Levenberg-Marquardt asks for them.
struct Residuals : Eigen::DenseFunctor<double> {
  const std::vector<LawMeasurement>& data;
  const Unknowns& unknowns;
  Eigen::VectorXd weight;

  Residuals(const std::vector<LawMeasurement>& d, const Unknowns& u)
      : DenseFunctor(static_cast<int>(u.free.size()), static_cast<int>(d.size())), data(d), unknowns(u) {
    weight = Eigen::VectorXd::Ones(values());
  }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& residual) const {
    const Law law = unknowns.at(x);
    for (std::size_t i = 0; i < data.size(); ++i)
      residual[i] = weight[i] *
                    (data[i].value - data[i].drive * conductance(law, data[i].pressure, data[i].viscosity).h);
    return residual.allFinite() ? 0 : -1;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& slopes) const {
    const Law law = unknowns.at(x);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const auto of_h = law_slopes(law, data[i].pressure, data[i].viscosity);
      for (std::size_t j = 0; j < unknowns.free.size(); ++j)
        slopes(i, j) = -weight[i] * data[i].drive * of_h[unknowns.free[j]];
    }
    return 0;
  }
};

struct Optimum {
  Eigen::VectorXd x, residual;
  double squares = std::numeric_limits<double>::infinity();
};

/// Laws to start from: h from below to above the data, x = 1 in their middle, all likely exponents.
std::vector<Law> starts(const std::vector<LawMeasurement>& data) {
  double lowest = std::numeric_limits<double>::infinity(), highest = 0, log_p = 0, log_eta = 0;
  int pressed = 0;
  for (const auto& row : data) {
    const double h = row.value / row.drive;
    if (row.drive != 0 && h > 0) lowest = std::min(lowest, h), highest = std::max(highest, h);
    if (row.pressure > 0) log_p += std::log(row.pressure), ++pressed;
    log_eta += std::log(row.viscosity) / static_cast<double>(data.size());
  }
  const double p = pressed > 0 ? std::exp(log_p / pressed) : 1;
  if (highest == 0) lowest = highest = 1;
  std::vector<Law> laws;
  for (const double beyond : {1.2, 5.0})
    for (const double by_p : {0.5, 1.0, 2.0})
      for (const double by_eta : {0.1, 0.4, 1.0})
        laws.push_back({lowest / beyond, highest * beyond, p, std::exp(log_eta), by_p, by_eta});
  return laws;
}

/// Moves the constant that p_ref and eta_ref make together to the one that is free, so that x = 1 stays where it was.
Law shift_reference(Law start, const Law& held, const std::array<bool, law_constants>& is_held) {
  const double log_c = start.b * std::log(start.eta_ref) - start.a * std::log(start.p_ref);
  for (int constant = 0; constant < law_constants; ++constant)
    if (is_held[constant]) constant_of(start, constant) = constant_of(held, constant);
  if (!is_held[eta_ref] && start.b > 0) start.eta_ref = std::exp((log_c + start.a * std::log(start.p_ref)) / start.b);
  else if (!is_held[p_ref] && start.a > 0)
    start.p_ref = std::exp((start.b * std::log(start.eta_ref) - log_c) / start.a);
  return start;
}

Optimum optimise(Residuals& residuals, Eigen::VectorXd x) {
  if (x.size() > 0) {
    Eigen::LevenbergMarquardt<Residuals> method(residuals);
    method.setMaxfev(400);
    method.setFtol(1e-14);
    method.setXtol(1e-12);
    method.minimize(x);
  }
  Eigen::VectorXd residual(residuals.values());
  if (!x.allFinite() || residuals(x, residual) < 0) return {};
  return {x, residual, residual.squaredNorm()};
}

Optimum optimise(Residuals& residuals, const LawFitOptions& options) {
  Optimum best;
  for (const Law& start : starts(residuals.data)) {
    auto found = optimise(residuals, residuals.unknowns.of(shift_reference(start, options.held, options.is_held)));
    if (found.squares < best.squares) best = std::move(found);
  }
  return best;
}

/// Least squares of shares of the fitted values: shares of the measured ones would favour those that came out low.
Optimum optimise_shares(Residuals& residuals, const LawFitOptions& options) {
  constexpr int rounds = 5;
  for (int i = 0; i < residuals.values(); ++i) residuals.weight[i] = 1 / std::abs(residuals.data[i].value);
  Optimum best = optimise(residuals, options);
  for (int round = 0; round < rounds && std::isfinite(best.squares); ++round) {
    const Law law = residuals.unknowns.at(best.x);
    for (int i = 0; i < residuals.values(); ++i) {
      const auto& row = residuals.data[i];
      residuals.weight[i] = 1 / std::abs(row.drive * conductance(law, row.pressure, row.viscosity).h);
    }
    best = optimise(residuals, best.x);
  }
  return best;
}

/// Half widths of the 95 % intervals in the fit's own unknowns; infinite where a direction that the data do not see has a
/// part of the unknown.
Eigen::VectorXd half_widths(const Eigen::MatrixXd& slopes, double scatter, int freedom) {
  constexpr double unseen = 1e-9, part = 1e-3;
  const Eigen::VectorXd size = slopes.colwise().norm();
  const Eigen::VectorXd scale = (size.array() > 0).select(size.cwiseInverse(), Eigen::VectorXd::Ones(size.size()));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double t = quantile(boost::math::students_t(freedom), 0.975);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(size.size());
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k)
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const double share = svd.matrixV()(i, k), seen = svd.singularValues()[k];
      if (seen > unseen * svd.singularValues()[0]) variance[i] += share * share / (seen * seen);
      else if (std::abs(share) > part) variance[i] = std::numeric_limits<double>::infinity();
    }
  return t * scatter * scale.cwiseProduct(variance.cwiseSqrt());
}

void add_intervals(LawFit& fit, const Unknowns& unknowns, const Eigen::VectorXd& x, const Eigen::VectorXd& half) {
  const double widest_log = std::log(10.0), widest_exponent = 2;
  for (std::size_t i = 0; i < unknowns.free.size(); ++i) {
    const int constant = unknowns.free[i];
    auto& found = fit.constants[constant];
    const auto back = [&](double value) { return is_exponent(constant) ? value : std::exp(value); };
    found.low = back(x[i] - half[i]);
    found.high = back(x[i] + half[i]);
    found.known = half[i] < (is_exponent(constant) ? widest_exponent : widest_log);
    if (!found.known)
      fit.warnings.push_back(fmt::format(
          "{0} is not identifiable from these data (its 95 % interval spans more than a factor 10, or an exponent's more "
          "than 2 either way); measure more, or hold it: --hold {0}=VALUE",
          law_constant_names[constant]));
    else if (is_exponent(constant) && found.low <= 0)
      fit.warnings.push_back(fmt::format("{} may be zero: its 95 % interval contains it", law_constant_names[constant]));
  }
}

/// Holds an exponent that came out below zero at zero; without b only p_ref is left to place x = 1. False when none did.
bool hold_negative_exponent(const Law& found, LawFitOptions& options, std::vector<std::string>& warnings) {
  for (const int constant : {a, b})
    if (!options.is_held[constant] && constant_of(found, constant) < 0) {
      options.is_held[constant] = true;
      constant_of(options.held, constant) = 0;
      warnings.push_back(fmt::format("{} came out below zero and is held at 0: these data do not show that h {}",
                                     law_constant_names[constant],
                                     constant == a ? "rises with the pressure" : "falls with the viscosity"));
      if (constant == b && !options.is_held[eta_ref]) {
        options.is_held[eta_ref] = true;
        options.held.eta_ref = found.eta_ref;
        options.is_held[p_ref] = options.is_held[a] && options.held.a == 0;
      }
      return true;
    }
  return false;
}

Unknowns unknowns_of(const LawFitOptions& options) {
  Unknowns unknowns{options.held, {}};
  for (int constant = 0; constant < law_constants; ++constant)
    if (!options.is_held[constant]) unknowns.free.push_back(constant);
  return unknowns;
}

void require_data(const std::vector<LawMeasurement>& data, const Unknowns& unknowns, bool relative) {
  if (data.size() <= unknowns.free.size())
    throw core::CaseError(fmt::format(
        "fit-law: {} rows were found, allowed are at least {} for {} free constants (fewer with --hold NAME=VALUE)",
        data.size(), unknowns.free.size() + 1, unknowns.free.size()));
  if (relative && std::any_of(data.begin(), data.end(), [](const auto& row) { return row.value * row.drive == 0; }))
    throw core::CaseError("fit-law: a value or a difference of temperature of zero was found, allowed with --relative are "
                          "others");
}

}  // namespace

double& constant_of(PressureViscosityConductance& law, int constant) {
  double* const places[] = {&law.h0, &law.h1, &law.p_ref, &law.eta_ref, &law.a, &law.b};
  return *places[constant];
}

double constant_of(const PressureViscosityConductance& law, int constant) {
  auto copy = law;
  return constant_of(copy, constant);
}

std::array<double, law_constants> law_slopes(const PressureViscosityConductance& law, double pressure, double viscosity) {
  if (pressure <= 0) return {law.h0, 0, 0, 0, 0, 0};
  const double by_p = std::log(pressure / law.p_ref), by_eta = std::log(law.eta_ref / viscosity);
  const double share = 1 / (1 + std::exp(-law.a * by_p - law.b * by_eta));
  const double by_log_x = (law.h1 - law.h0) * share * (1 - share);
  return {law.h0 * (1 - share), law.h1 * share,      -law.a * by_log_x,
          law.b * by_log_x,     by_p * by_log_x, by_eta * by_log_x};
}

LawFit fit_law(const std::vector<LawMeasurement>& data, const LawFitOptions& given) {
  LawFitOptions options = given;
  LawFit fit;
  for (;;) {
    const Unknowns unknowns = unknowns_of(options);
    require_data(data, unknowns, options.relative);
    Residuals residuals(data, unknowns);
    const Optimum optimum = options.relative ? optimise_shares(residuals, options) : optimise(residuals, options);
    if (!std::isfinite(optimum.squares))
      throw core::CaseError("fit-law: no constants of the law give finite values for these data");
    fit.law = unknowns.at(optimum.x);
    if (hold_negative_exponent(fit.law, options, fit.warnings)) continue;
    fit.freedom = static_cast<int>(data.size() - unknowns.free.size());
    fit.scatter = std::sqrt(optimum.squares / fit.freedom);
    fit.residual.assign(optimum.residual.data(), optimum.residual.data() + optimum.residual.size());
    for (int constant = 0; constant < law_constants; ++constant) {
      const double value = constant_of(fit.law, constant);
      fit.constants[constant] = {value, value, value, options.is_held[constant], true};
    }
    Eigen::MatrixXd slopes(data.size(), unknowns.free.size());
    residuals.df(optimum.x, slopes);
    if (!unknowns.free.empty()) add_intervals(fit, unknowns, optimum.x, half_widths(slopes, fit.scatter, fit.freedom));
    if (fit.law.h1 < fit.law.h0) fit.warnings.push_back("h1 came out below h0: these data say that h falls with the pressure");
    return fit;
  }
}

}  // namespace parison::contact
