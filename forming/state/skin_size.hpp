#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "thermal/skin_error.hpp"

namespace parison::forming {

/// A body (glass_body, body_of_tool) as a half-space at its first temperature, meshed with such first cells, m, which
/// grow as its mesh does. Radiation inside the glass counts for nothing: it widens the skin.
thermal::SkinSide skin_side(const Scene& scene, Index body, double first_cell);

/// Time for which a tool is active up to the end of a stage, s.
double active_time(const Scene& scene, Index tool, Index last_stage);

/// Conductance, W/m2/K, from which on a contact of the glass with a tool counts as perfect.
double perfect_contact(const Scene& scene, const Interface& interface);

/// The largest h, W/m2/K, through which a boundary of a body's outline exchanges heat with surroundings of another
/// temperature than its own in the stages up to `last_stage`; infinite where its temperature is given, else 0.
double surroundings_conductance(const Scene& scene, Index body, std::size_t boundary, Index last_stage);

/// Edge on such a boundary, m, at most `wanted`, with which the heat through it in the whole run is free of the error
/// of a skin thinner than its first cells.
double surroundings_edge(const Scene& scene, Index body, std::size_t boundary, double wanted);

/// Edge on the contact boundaries of a body, m, at most `wanted`, with which the heat that it exchanges in the whole
/// run is free of the error of a skin thinner than its first cells.
double contact_edge(const Scene& scene, Index body, double wanted);

/// The same of the glass where it touches one tool, for the heat exchanged up to the end of `last_stage`: what a later
/// stage does has no influence on the mesh of an earlier one.
double glass_edge_at_tool(const Scene& scene, const Interface& interface, double wanted, Index last_stage);

}  // namespace parison::forming
