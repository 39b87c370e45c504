#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/scene/calibration.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

/// A model of radiation by its name in a case, with what was measured of it against `transfer`.
struct RankedModel {
  std::string name;
  double error;  ///< the largest of all measured scenes, of the wall in the mean and of the heat into tools, a share
  double cost;   ///< CPU time of a run over that by `transfer`, geometric mean over the scenes
};

/// The model that `radiation.model = "auto"` took.
struct RadiationChoice {
  std::string material;  ///< of the glass
  double within;         ///< the error that was asked for, a share
  RankedModel model;
};

/// The models of a calibration, the cheapest first, with `transfer` itself: error 0, cost 1. One that was not measured
/// in every scene is left out.
std::vector<RankedModel> ranked_models(const MeasuredRadiation& measured);

/// The first of `models` that has one of the `allowed` names and an error of at most `within`, a share. Models after
/// `transfer` cost more than it and are not taken.
RankedModel cheapest_model(const std::vector<RankedModel>& models, const std::vector<std::string>& allowed,
                           double within);

/// The name in a case of the model of a glass.
std::string model_name(const std::optional<thermal::Radiation>& radiation);

/// What a run says of a choice.
std::string describe(const RadiationChoice& choice);

}  // namespace parison::forming
