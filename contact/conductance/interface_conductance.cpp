// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/interface_conductance.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parison::contact {

namespace {

using Values = Eigen::Ref<Eigen::ArrayXd>;
using Given = Eigen::Ref<const Eigen::ArrayXd>;

/// The points of a run: what they keep, their viscosities, and where the result goes.
struct Batch {
  Given pressure, log_pressure_factor, log_viscosity;
  Values h;
  double* derivative;  ///< null: not wanted

  Eigen::Map<Eigen::ArrayXd> derivatives() const { return {derivative, h.size()}; }
};

constexpr double max_log = 700;  ///< of x: beyond, the exponential overflows and the law is at its end

core::Index evaluate(const ConstantConductance& law, Batch batch) {
  batch.h.setConstant(law.h);
  if (batch.derivative) batch.derivatives().setZero();
  return 0;
}

core::Index evaluate(const PressureViscosityConductance& law, Batch batch) {
  Values x = batch.h;
  x = (batch.log_pressure_factor - law.b * batch.log_viscosity).max(-max_log).min(max_log).exp();
  const double range = law.h1 - law.h0;
  if (batch.derivative) batch.derivatives() = -law.b * range * (x / (1 + x)) / (1 + x);
  batch.h = law.h0 + range * (x / (1 + x));
  return 0;
}

core::Index evaluate(const TableConductance& law, Batch batch) {
  core::Index clamped = 0;
  for (Eigen::Index i = 0; i < batch.h.size(); ++i) {
    const double viscosity = std::exp(batch.log_viscosity[i]);
    const ConductanceValue value = conductance(law, batch.pressure[i], viscosity);
    batch.h[i] = value.h;
    if (batch.derivative) batch.derivative[i] = viscosity * value.dh_deta;
    clamped += value.outside;
  }
  return clamped;
}

double log_pressure_factor(const ConductanceLaw& law, double pressure) {
  const auto* pressure_law = std::get_if<PressureViscosityConductance>(&law);
  if (!pressure_law) return 0;
  const double part = pressure_law->a > 0 ? pressure_law->a * std::log(pressure / pressure_law->p_ref) : 0;  // 0^0 is 1
  return part + pressure_law->b * std::log(pressure_law->eta_ref);
}

}  // namespace

InterfaceConductance::InterfaceConductance(std::vector<ConductanceLaw> laws,
                                           const std::vector<core::InterfacePoint>& points)
    : laws_(std::move(laws)), pressure_(points.size()), log_pressure_factor_(points.size()) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const core::Index law = points[i].law, at = static_cast<core::Index>(i);
    if (i == 0 || law != points[i - 1].law) runs_.push_back({law, at, 0});
    ++runs_.back().count;
    pressure_[at] = points[i].pressure;
    log_pressure_factor_[at] = log_pressure_factor(laws_[law], std::max(points[i].pressure, 0.0));
  }
}

core::Index InterfaceConductance::operator()(const Eigen::ArrayXd& log_viscosity, Eigen::ArrayXd& h,
                                             Eigen::ArrayXd* dh_dlog) const {
  core::Index clamped = 0;
  for (const auto& [law, first, count] : runs_) {
    const Batch batch{pressure_.segment(first, count), log_pressure_factor_.segment(first, count),
                      log_viscosity.segment(first, count), h.segment(first, count),
                      dh_dlog ? dh_dlog->data() + first : nullptr};
    clamped += std::visit([&](const auto& l) { return evaluate(l, batch); }, laws_[law]);
  }
  return clamped;
}

}  // namespace parison::contact
