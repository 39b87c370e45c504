// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/conductance/gap_conductance.hpp"

namespace parison::contact {

double GapConductance::opening_after(double opening, double closing_rate, double time) const {
  const double rate = 1 / opening_time + closing_rate;
  const double settled = (open_gap - touch_gap) / (opening_time * rate);
  return opening - (settled - opening) * std::expm1(-rate * time);
}

}  // namespace parison::contact
