// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/law/law_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <vector>

#include "core/case/case_error.hpp"

namespace parison::contact {

namespace {

inline bool is_exponent(int constant) {
  return constant == law_constant::a || constant == law_constant::b;
}

/// The free constants as the fit sees them: logarithms, but the exponents themselves.
struct LawUnknowns {
  PressureViscosityConductance fixed;  ///< with the fixed constants
  std::vector<int> free;

  PressureViscosityConductance law(const Eigen::VectorXd& x) const;
  Eigen::VectorXd of(const PressureViscosityConductance& law) const;
};
LawUnknowns unknowns_of(const LawFitOptions& options);

/// Where the sum of squares is smallest; infinite `squares` where no start led to finite values.
struct LawOptimum {
  Eigen::VectorXd x, residual;
  Eigen::MatrixXd jacobian;  ///< of the residuals with the unknowns
  double squares = std::numeric_limits<double>::infinity();
};

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

/// Half widths of the 95 % intervals in the fit's own unknowns; infinite where a direction that the data do not see has
/// a part of the unknown.
Eigen::VectorXd half_widths(const Eigen::MatrixXd& jacobian, double scatter, int freedom) {
  constexpr double unseen = 1e-9, part = 1e-3;
  const Eigen::VectorXd size = jacobian.colwise().norm();
  const Eigen::VectorXd scale = (size.array() > 0).select(size.cwiseInverse(), Eigen::VectorXd::Ones(size.size()));
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian * scale.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const double t = quantile(boost::math::students_t(freedom), 0.975);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(size.size());
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k)
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const double fraction = svd.matrixV()(i, k), nonsingular = svd.singularValues()[k];
      if (nonsingular > unseen * svd.singularValues()[0])
        variance[i] += fraction * fraction / (nonsingular * nonsingular);
      else if (std::abs(fraction) > part)
        variance[i] = std::numeric_limits<double>::infinity();
    }
  return t * scatter * scale.cwiseProduct(variance.cwiseSqrt());
}

void add_intervals(LawFit& fit, const LawUnknowns& unknowns, const Eigen::VectorXd& x, const Eigen::VectorXd& half) {
  const double widest_log = std::log(10.0), widest_exponent = 2;
  for (std::size_t i = 0; i < unknowns.free.size(); ++i) {
    const int constant = unknowns.free[i];
    auto& found = fit.constants[constant];
    const auto back = [&](double value) { return is_exponent(constant) ? value : std::exp(value); };
    found.low = back(x[i] - half[i]);
    found.high = back(x[i] + half[i]);
    found.known = half[i] < (is_exponent(constant) ? widest_exponent : widest_log);
    if (!found.known)
      fit.warnings.push_back(
          fmt::format("{0} is not identifiable from these data (its 95 % interval spans more than a factor 10, or an "
                      "exponent's more "
                      "than 2 either way); measure more, or fix it: --fix {0}=VALUE",
                      law_constant_names[constant]));
    else if (is_exponent(constant) && found.low <= 0)
      fit.warnings.push_back(
          fmt::format("{} may be zero: its 95 % interval contains it", law_constant_names[constant]));
  }
}

/// Fixes an exponent that came out below zero at zero; without b only p_ref remains to scale x. False when none
/// did.
bool fix_negative_exponent(const Law& found, LawFitOptions& options, std::vector<std::string>& warnings) {
  for (const int constant : {a, b})
    if (!options.is_fixed[constant] && constant_of(found, constant) < 0) {
      options.is_fixed[constant] = true;
      constant_of(options.fixed, constant) = 0;
      warnings.push_back(fmt::format("{} came out below zero and is fixed at 0: these data do not show that h {}",
                                     law_constant_names[constant],
                                     constant == a ? "rises with the pressure" : "falls with the viscosity"));
      if (constant == b && !options.is_fixed[eta_ref]) {
        options.is_fixed[eta_ref] = true;
        options.fixed.eta_ref = found.eta_ref;
        options.is_fixed[p_ref] = options.is_fixed[a] && options.fixed.a == 0;
      }
      return true;
    }
  return false;
}

void require_data(const std::vector<LawMeasurement>& data, const LawUnknowns& unknowns, bool relative) {
  if (data.size() <= unknowns.free.size())
    throw core::CaseError(fmt::format(
        "--law: {} rows were found, allowed are at least {} for {} free constants (fewer with --fix NAME=VALUE)",
        data.size(), unknowns.free.size() + 1, unknowns.free.size()));
  if (relative && std::any_of(data.begin(), data.end(), [](const auto& row) { return row.value * row.drive == 0; }))
    throw core::CaseError(
        "--law: a value or a difference of temperature of zero was found, allowed with --relative are "
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

std::array<double, law_constants> law_derivatives(const PressureViscosityConductance& law, double pressure,
                                                  double viscosity) {
  using Constant = core::Dual<double, Eigen::Array<double, law_constants, 1>>;
  const auto unit = [](int constant) -> Eigen::Array<double, law_constants, 1> {
    return Eigen::Matrix<double, law_constants, 1>::Unit(constant);
  };
  const auto in_logarithm = [&](double value, int constant) { return Constant{value, value * unit(constant)}; };
  const PressureViscosityLaw<Constant> dual{
      in_logarithm(law.h0, h0),           in_logarithm(law.h1, h1), in_logarithm(law.p_ref, p_ref),
      in_logarithm(law.eta_ref, eta_ref), {law.a, unit(a)},         {law.b, unit(b)}};
  const Constant h = dual(core::constant_like(dual.a, std::max(pressure, 0.0)), core::constant_like(dual.a, viscosity));
  std::array<double, law_constants> derivatives;
  std::copy(h.derivative.begin(), h.derivative.end(), derivatives.begin());
  return derivatives;
}

LawFit fit_law(const std::vector<LawMeasurement>& data, const LawFitOptions& given) {
  LawFitOptions options = given;
  LawFit fit;
  for (;;) {
    const LawUnknowns unknowns = unknowns_of(options);
    require_data(data, unknowns, options.relative);
    const LawOptimum optimum = find_optimum(data, options, unknowns);
    if (!std::isfinite(optimum.squares))
      throw core::CaseError("--law: no constants of the law give finite values for these data");
    fit.law = unknowns.law(optimum.x);
    if (fix_negative_exponent(fit.law, options, fit.warnings)) continue;
    fit.freedom = static_cast<int>(data.size() - unknowns.free.size());
    fit.scatter = std::sqrt(optimum.squares / fit.freedom);
    fit.residual.assign(optimum.residual.data(), optimum.residual.data() + optimum.residual.size());
    for (int constant = 0; constant < law_constants; ++constant) {
      const double value = constant_of(fit.law, constant);
      fit.constants[constant] = {value, value, value, options.is_fixed[constant], true};
    }
    if (!unknowns.free.empty())
      add_intervals(fit, unknowns, optimum.x, half_widths(optimum.jacobian, fit.scatter, fit.freedom));
    if (fit.law.h1 < fit.law.h0)
      fit.warnings.push_back("h1 came out below h0: these data say that h falls with the pressure");
    return fit;
  }
}

}  // namespace parison::contact
