#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// How far temperatures of a body went beyond the table of a property.
struct TableExcess {
  double error = 0;  ///< estimated relative error of the property, mean over the volume or the surface, largest so far
  double furthest = 0;  ///< beyond the table, K
  double seconds = 0;   ///< in which some temperature was beyond it
};

/// The same of all properties of a body.
struct TablesExcess {
  TableExcess conductivity, heat_capacity;
  TableExcess flow;  ///< viscosity of the glass, friction of the glass on a tool
};

/// Whether any property of the scene is a table over temperature.
bool has_property_tables(const Scene& scene);

/// Follows, after a step of length dt, s, how far temperatures of a body lie beyond the tables of its properties
/// and by how much these are wrong then. Beyond its ends a table of conductivity, heat capacity or friction is
/// constant: the estimate is the change that it would have if it went on as at its end, or as in the mean, whichever is
/// more. The logarithm of a viscosity goes on straight: the estimate is its curvature, or that of Arrhenius' law, over
/// the excess.
void follow_tables(const Scene& scene, const State& state, Index body, double dt, TablesExcess& excess);

template <typename Visitor, typename Tables>
void visit_tables(Visitor visit, Tables& tables) {
  visit("conductivity_error", tables.conductivity.error);
  visit("conductivity_furthest", tables.conductivity.furthest);
  visit("conductivity_seconds", tables.conductivity.seconds);
  visit("heat_capacity_error", tables.heat_capacity.error);
  visit("heat_capacity_furthest", tables.heat_capacity.furthest);
  visit("heat_capacity_seconds", tables.heat_capacity.seconds);
  visit("flow_error", tables.flow.error);
  visit("flow_furthest", tables.flow.furthest);
  visit("flow_seconds", tables.flow.seconds);
}

}  // namespace parison::forming
