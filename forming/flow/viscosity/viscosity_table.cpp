// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/viscosity/viscosity_table.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "forming/flow/viscosity/composition.hpp"

namespace parison::flow {

ViscosityTable::ViscosityTable(std::vector<double> temperature, const std::vector<double>& viscosity)
    : temperature_(std::move(temperature)) {
  assert(temperature_.size() >= 2 && temperature_.size() == viscosity.size());
  const std::size_t last = temperature_.size() - 1;
  for (const double eta : viscosity) logarithm_.push_back(std::log(eta));
  const auto secant = [this](std::size_t i) {
    return (logarithm_[i + 1] - logarithm_[i]) / (temperature_[i + 1] - temperature_[i]);
  };
  slope_.push_back(secant(0));
  for (std::size_t i = 1; i < last; ++i) {
    const double before = temperature_[i] - temperature_[i - 1], behind = temperature_[i + 1] - temperature_[i];
    const double share = (before + 2 * behind) / (3 * (before + behind));
    slope_.push_back(secant(i - 1) * secant(i) / (share * secant(i) + (1 - share) * secant(i - 1)));
  }
  slope_.push_back(secant(last - 1));
}

ViscosityTable::Value ViscosityTable::operator()(double temperature) const {
  const std::size_t last = temperature_.size() - 1;
  for (const std::size_t end : {std::size_t{0}, last})
    if (end == 0 ? temperature <= temperature_[0] : temperature >= temperature_[last])
      return {logarithm_[end] + slope_[end] * (temperature - temperature_[end]), slope_[end]};
  const auto above = std::upper_bound(temperature_.begin(), temperature_.end(), temperature);
  const std::size_t i = static_cast<std::size_t>(above - temperature_.begin()) - 1;
  const double width = temperature_[i + 1] - temperature_[i], s = (temperature - temperature_[i]) / width;
  const double rise = logarithm_[i + 1] - logarithm_[i], m0 = width * slope_[i], m1 = width * slope_[i + 1];
  const double c2 = 3 * rise - 2 * m0 - m1, c3 = m0 + m1 - 2 * rise;
  return {logarithm_[i] + s * (m0 + s * (c2 + s * c3)), (m0 + s * (2 * c2 + 3 * s * c3)) / width};
}

double ViscosityTable::error_beyond(double temperature) const {
  const std::size_t last = temperature_.size() - 1, middle = temperature_.size() / 2;
  if (temperature >= coldest() && temperature <= hottest()) return 0;
  const std::size_t end = temperature < coldest() ? 0 : last;
  const double excess = temperature - temperature_[end];
  const double of_arrhenius = std::abs(slope_[end] * excess * excess / temperature);
  if (last < 2) return of_arrhenius;
  const auto decades = [this](std::size_t i) { return logarithm_[i] / std::log(10); };
  const Viscosity law = vft_through({temperature_[last], temperature_[middle], temperature_[0]},
                                    {decades(last), decades(middle), decades(0)});
  if (!(law.B > 0) || !(law.T0 > 0 && law.T0 < coldest())) return of_arrhenius;
  if (temperature <= law.T0) return std::numeric_limits<double>::infinity();
  const auto of_law = [&](double T) { return std::log(10) * law.B / (T - law.T0); };
  const double slope = -of_law(temperature_[end]) / (temperature_[end] - law.T0);
  return std::abs(of_law(temperature) - of_law(temperature_[end]) - slope * excess);
}

}  // namespace parison::flow
