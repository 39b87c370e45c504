// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/accuracy.hpp"

#include <fmt/core.h>

#include "core/case_error.hpp"

namespace parison::forming {
namespace {

Accuracy draft() {
  Accuracy a;
  a.surface_size = 1.0e-3;
  a.skin_size = 0.4e-3;
  a.elements_across = 3;
  a.glass_growth = 0.5;
  a.tool_contact_size = 1.5e-3;
  a.tool_growth = 0.5;
  a.strain_per_step = 0.3;
  a.temperature_tolerance = 1.0;
  a.temperature_per_step = 40;
  a.largest_step = 0.1;
  a.first_step = 1e-3;
  a.smallest_step = 1e-6;
  a.quality_floor = 0.15;
  a.motion_tolerance = 0.1e-3;
  a.temperature_order = 2;
  a.passes = 1;
  return a;
}

/// Half the sizes and steps, a fifth of the heat tolerance, two flow-heat sweeps.
Accuracy refined(Accuracy a) {
  a.surface_size /= 2;
  a.skin_size /= 2;
  a.elements_across *= 1.5;
  a.tool_contact_size /= 2;
  a.strain_per_step /= 2;
  a.temperature_tolerance /= 5;
  a.temperature_per_step /= 2;
  a.largest_step /= 2;
  a.quality_floor = 0.2;
  a.motion_tolerance /= 4;
  a.passes = 2;
  return a;
}

}  // namespace

Accuracy accuracy_preset(const std::string& name) {
  if (name == "draft") return draft();
  if (name == "standard") return refined(draft());
  if (name == "fine") return refined(refined(draft()));
  throw core::CaseError(fmt::format("accuracy: \"{}\" was found, allowed are draft, standard, fine", name));
}

}  // namespace parison::forming
