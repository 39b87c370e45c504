#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/case/units.hpp"

namespace parison::forming {

/// Everything numerical that the accuracy level sets; each can be overridden under [numerics] in the case file.
struct Accuracy {
  double surface_size;        ///< largest edge on the glass surface, m
  double skin_size;           ///< smallest edge asked for where hot glass meets a cold tool, m
  double viscosity_per_edge;  ///< change of the logarithm of the viscosity over an edge of the glass surface, at most
  double elements_across;     ///< elements across a glass wall
  double tool_contact_size;   ///< edge on a tool's contact boundaries, m
  double strain_per_step;     ///< rate of deformation times step, seen by 2 % of the glass
  double landing_per_step;    ///< length of surface that comes into contact in one step, over surface_size
  double work_per_step;       ///< largest work_error of a step
  double temperature_tolerance;  ///< local error of a heat step, K
  double temperature_per_step;   ///< largest change of the glass surface temperature in a coupled step, K
  double light_rays;             ///< that find the exchange of light in the glass
  double max_step;               ///< s
  double initial_step;           ///< of each stage, s
  double min_step;               ///< s; a run that needs less stops
  double max_cells;              ///< of the glass, about: sizes that ask for more grow
  double quality_floor;          ///< remesh below this scaled inverse condition number
  double motion_tolerance;       ///< a coupling iteration whose velocity moves the mid-step mesh by more than this is
                                 ///< repeated, m
};

/// Growth of the edge with the distance from the surface of the glass or the contact boundaries of a tool.
inline constexpr double edge_growth = 0.5;

/// A setting of the accuracy level: its key, how it is shown, and its values at the levels 0, 1, 2.
struct Setting {
  const char* key;
  double Accuracy::*value;
  core::Dimension dimension;
  const char* unit;  ///< in which it is shown
  double unit_size;  ///< SI
  double order;      ///< goes with this power of the edge length when a whole run is made coarser; 0: it does not
  std::array<double, 3> levels;
  double min, max;  ///< that a case may ask for, SI
};
const std::vector<Setting>& settings();

/// The accuracy level as one number: 0 is draft, 1 standard, 2 fine, and every setting runs evenly in its logarithm
/// between and beyond them.
Accuracy accuracy_at(double level);

/// The same run with edges and steps `factor` times as long, tolerances to match.
Accuracy coarsened(Accuracy accuracy, double factor);

/// What an --accuracy text asks for: a preset or a share such as "0.5%", and perhaps " coarser 1.5" behind it.
struct AccuracyChoice {
  double level = 0;
  std::optional<double> target;  ///< share of the wall thickness and of the heat into tools, when given so
  double coarsening_factor =
      1;  ///< edges and steps of the whole scene, the case's own included, are so many times longer
  /// The level at which the error law of the presets would see it.
  double effective_level() const { return level - std::log2(coarsening_factor); }
};
/// Factors that a text may ask for.
inline constexpr double min_coarsening = 0.05, max_coarsening = 20;
/// Throws core::CaseError where the text is no choice.
AccuracyChoice read_accuracy(const std::string& text);

/// The text of a choice `factor` times coarser.
std::string coarsened_text(const std::string& text, double factor);

/// The presets draft, standard and fine, or what another text asks for.
Accuracy accuracy_preset(const std::string& text);

/// The larger of the errors of wall thickness and heat that the calibration expects at a level, as a fraction.
double expected_error(double level);
/// The level that keeps both within the target.
double level_for(double target);

}  // namespace parison::forming
