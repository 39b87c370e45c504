#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::forming {

/// Everything numerical that the accuracy dial sets; each can be overridden under [numerics] in the case file.
struct Accuracy {
  double surface_size;       ///< largest edge on the glass surface, m
  double skin_size;          ///< smallest edge asked for where hot glass meets a cold tool, m
  double elements_across;    ///< elements across a glass wall
  double glass_growth;       ///< growth of the glass edge length with the distance from the surface
  double tool_contact_size;  ///< edge on a tool's contact pieces, m
  double tool_growth;        ///< growth of the edge with the distance from there
  double strain_per_step;    ///< rate of deformation times step, seen by 2 % of the glass
  double temperature_tolerance;  ///< local error of a heat step, K
  double temperature_per_step;   ///< largest change of the glass surface temperature in a coupled step, K
  double largest_step;       ///< s
  double first_step;         ///< of each stage, s
  double smallest_step;      ///< s; a run that needs less stops
  double quality_floor;      ///< remesh below this scaled inverse condition number
  double motion_tolerance;   ///< a sweep whose velocity moves the mid-step mesh by more than this is repeated, m
  int temperature_order;     ///< of the temperature in a cell: 2, or 1: linear between the vertices
  int passes;                ///< flow-heat sweeps per step, at least
};

/// The presets draft, standard and fine.
Accuracy accuracy_preset(const std::string& name);

}  // namespace parison::forming
