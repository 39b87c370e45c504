#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/io/json.hpp"
#include "core/io/vtu.hpp"
#include "forming/report/summary.hpp"

namespace parison::forming {

/// Temper numbers of ASTM C148: apparent, by the retardation, m, and real, for a standard thickness.
double apparent_temper_number(double retardation);
double real_temper_number(double retardation, double thickness);

/// Stress and fictive temperature at the nodes, for the VTU files: nothing of glass that has not cooled.
void add_stress_fields(const Scene& scene, const GlassState& glass, core::VtuFields& fields);
/// The object `cooling` of summary.json: hot and cold container, tensions, temper number.
void add_cooling(core::JsonWriter& json, const Summary& summary);
/// Adds what a search or a comparison asks of the cold container: `temper_number` (real, of the base), principal
/// tension in MPa, `residual_tension` anywhere in the glass, `residual_tension_surface`, `cooling_tension_surface` at
/// any time while it cooled, and `cooling_time`, s, from the take-out to the end. Nothing of glass that has not cooled.
void add_cooling_quantities(const Scene& scene, const State& state, const Summary& summary, Quantities& found);
/// Those that a run of a scene may have: names and units.
std::vector<std::pair<const char*, const char*>> cooling_quantities_of(const Scene& scene);

/// The same as lines of the table of results.
struct LabelledText {
  std::string label, text;
};
std::vector<LabelledText> cooling_lines(const Summary& summary);

}  // namespace parison::forming
