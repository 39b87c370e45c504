// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/solid/whole_turn.hpp"

#include <cmath>

#include "core/math/numbers.hpp"

namespace parison::forming {

Copies::Copies(const SolidState& solid)
    : count_(static_cast<int>(std::lround(1 / solid.share))), sector_(2 * M_PI * solid.share) {}

core::Vector3 Copies::millimetres(const core::Vector3& at, int copy) const {
  constexpr double per_nanometre = 1e6;  // mm
  const double turn = sector_ * (is_mirrored(copy) ? copy + 1 : copy), cosine = std::cos(turn), sine = std::sin(turn);
  const double y = is_mirrored(copy) ? -at[1] : at[1];
  const core::Vector3 turned(cosine * at[0] - sine * y, sine * at[0] + cosine * y, at[2]);
  return ((per_nanometre / core::millimetre * turned).array().round() / per_nanometre + 0.0).matrix();
}

}  // namespace parison::forming
