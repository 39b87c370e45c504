#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// The thermal contact of the glass with a tool that goes on, and what the contacts before it left: by these the run
/// knows how well its meshes resolve the skin.
struct ContactSkin {
  double area_time = 0;    ///< integral of the area over time, m2 s; the next three are means when divided by it
  double conductance = 0;  ///< of h, W s/K
  double glass_cell = 0;   ///< of the height of the glass's cells at the surface, m3 s
  double tool_cell = 0;    ///< of that of the tool's cells, m3 s
  double peak_area = 0;    ///< m2
  double heat = 0;         ///< into the tool in this contact, J
  double wrong = 0;        ///< estimated error of the heat of earlier contacts, without sign, J
  double exchanged = 0;    ///< heat of all contacts without sign, J
};

/// Adds a heat step to the contacts of all tools; the skins are by tool.
void follow_contact_skins(const Scene& scene, const State& before, const StepResult& step,
                          std::vector<ContactSkin>& skins);

/// Estimated error of the heat that a tool has exchanged, of that heat without sign: thermal::skin_error for the mean
/// time, conductance and first cells of each of its contacts. NaN where it exchanged none.
double contact_skin_error(const Scene& scene, const State& state, Index tool, ContactSkin skin);

template <typename Visitor, typename Skin>
void visit_skin(Visitor visit, Skin& skin) {
  visit("area_time", skin.area_time);
  visit("conductance", skin.conductance);
  visit("glass_cell", skin.glass_cell);
  visit("tool_cell", skin.tool_cell);
  visit("peak_area", skin.peak_area);
  visit("heat", skin.heat);
  visit("wrong", skin.wrong);
  visit("exchanged", skin.exchanged);
}

}  // namespace parison::forming
