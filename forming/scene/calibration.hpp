#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>
#include <vector>

namespace parison::forming {

/// An error that falls with the accuracy level: at_draft * 2^(-order * level), as a fraction.
struct ErrorLaw {
  double at_draft, order;
  double at(double level) const;
};

/// The change that a part of the model caused where it was measured, and its dimensionless number there.
struct MeasuredPart {
  double number;
  double thickness, heat;  ///< change of the wall thickness in the mean and of the heat into the tools, as fractions
};

/// What a model of radiation is off by in a scene against `transfer`.
struct MeasuredModel {
  double thickness, heat;  ///< of the wall in the mean and of the heat into the tools, as shares
  double cost;             ///< CPU time of the run over that by `transfer`
};

/// Models of radiation in all scenes in which they were measured, by their names in a case; with which program, when.
struct MeasuredRadiation {
  std::string commit, date;
  std::vector<std::map<std::string, MeasuredModel>> scenes;
};

/// Figures measured on bundled cases, from which errors and the effects of model parts are estimated on others. They
/// are in forming/scene/calibration.json, which `tools/bench --save` writes and the build takes into the program.
struct Calibration {
  struct {
    ErrorLaw thickness, heat;  ///< of the wall in the mean, of the heat into the tools
  } error_law;
  struct {
    double duration;  ///< of the case, s
    std::map<std::string, MeasuredPart> parts;
  } model_parts;
  struct {
    double pressed_freedom;    ///< change of a wall between tools on both sides over that of a blown wall
    double pressed_open_heat;  ///< heat of its open surface likewise
    double heat_of_strain;     ///< change of the heat into the tools over the strain of glass that nothing forms
  } model_shapes;
  MeasuredRadiation radiation;
};

/// Reads a calibration; throws std::runtime_error that names the entry where one is missing or no number.
Calibration read_calibration(const std::string& json);

/// That of this program.
const Calibration& calibration();

}  // namespace parison::forming
