#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"

namespace parison::forming {

/// What a model is off by against the best one of its part, at most over the scenes in which it was measured. NaN where
/// it was not measured.
struct ModelDifference {
  double thickness, thinnest, heat;  ///< wall in the mean, its thinnest place, heat into tools: shares
  double temperature;                ///< mean skin at the end of any stage, K
};

/// That of a model, by its name in a case, in a part of a calibration such as "radiation_models". Throws
/// std::runtime_error where the text is no JSON.
ModelDifference model_difference(const std::string& calibration, const std::string& part, const std::string& model);

/// Of each part of the physics of a scene with a choice of models the one in use and the best one, by their names in a
/// case.
std::vector<ModelUse> models_of(const Scene& scene);

/// Gives quantities the models of a scene and Quantity::model.
void add_models(const Scene& scene, Quantities& quantities);

/// Gives each quantity the sum over the models of what they are off by; 0 where each is the best of its part. Places,
/// extents, durations and forces were not measured. A heat is taken a share of size_of_kind.
void add_model_bars(const std::vector<ModelDifference>& differences, Quantities& quantities);

/// Quantity::model for a table: "-" where the run has the best models, "?" where it was not measured.
std::string model_text(double model);

/// "radiation rosseland (best: transfer)", of all models; empty without one.
std::string models_text(const std::vector<ModelUse>& models);

/// Of the models of a run that are not the best, what the best ones were found to move, for a terminal; else empty.
std::string models_move_text(const std::vector<ModelUse>& models);

}  // namespace parison::forming
