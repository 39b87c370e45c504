// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/law/law_fit.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "core/case/case_error.hpp"
#include "forming/study/law/law_optimum.hpp"

namespace parison::contact {
namespace {

using Law = PressureViscosityConductance;
using namespace law_constant;

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
