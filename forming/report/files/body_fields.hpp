#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/vtu.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The fields of the glass in its VTU files: those declared in glass_fields, viscosity, wall thickness, heat flux.
core::VtuFields glass_output(const Scene& scene, const State& state);
/// Those of a tool: its temperature, and whether the stage names it.
core::VtuFields tool_output(const Scene& scene, const State& state, Index tool);

/// Heat flux by conduction with internal radiation, -k grad T, at the nodes, W/m2: core::dim numbers each, the mean
/// over the cells around by their volume. `wall_thickness`, m at the nodes, limits the radiation in thin walls.
Eigen::VectorXd conducted_flux(const core::Mesh& mesh, core::Geometry geometry, const thermal::Material& material,
                               const Eigen::VectorXd& temperature, const Eigen::VectorXd& wall_thickness);

}  // namespace parison::forming
