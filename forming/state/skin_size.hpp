#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "thermal/skin_error.hpp"

namespace parison::forming {

/// A body (glass_body, body_of_tool) as a half-space at its first temperature, meshed with such first cells, m, which
/// grow as its mesh does. Radiation inside the glass counts for nothing: it widens the skin.
thermal::SkinSide skin_side(const Scene& scene, Index body, double first_cell);

/// Conductance, W/m2/K, from which on a contact of the glass with a tool counts as perfect.
double perfect_contact(const Scene& scene, const Interface& interface);

/// Edge on a boundary that meets surroundings of another temperature, m, at most `wanted`, with which the heat through
/// it up to the end of `last_stage` is free of the error of a skin thinner than its first cells.
double surroundings_edge(const Scene& scene, Index body, std::size_t boundary, double wanted, Index last_stage);

/// The stage up to which the first meshes are to resolve skins: the last that forms, or of all where none does. The end
/// of cooling takes half an hour and changes nothing before it.
Index last_meshed_stage(const Scene& scene);

/// Edge on the contact boundaries of a body, m, at most `wanted`, with which the heat that it exchanges until then is
/// free of the error of a skin thinner than its first cells.
double contact_edge(const Scene& scene, Index body, double wanted);

/// The same of the glass where it touches one tool, for the heat exchanged up to the end of `last_stage`: what a later
/// stage does has no influence on the mesh of an earlier one.
double glass_edge_at_tool(const Scene& scene, const Interface& interface, double wanted, Index last_stage);

}  // namespace parison::forming
