// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/radiation_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace parison::forming {
namespace {

constexpr const char* reference = "transfer";

}  // namespace

std::vector<RankedModel> ranked_models(const MeasuredRadiation& measured) {
  struct Sum {
    double error = 0, log_cost = 0;
    std::size_t scenes = 0;
  };
  std::map<std::string, Sum> sums;
  for (const auto& scene : measured.scenes)
    for (const auto& [name, model] : scene) {
      Sum& sum = sums[name];
      sum.error = std::max({sum.error, model.thickness, model.heat});
      sum.log_cost += std::log(model.cost);
      ++sum.scenes;
    }
  std::vector<RankedModel> models{{reference, 0, 1}};
  for (const auto& [name, sum] : sums)
    if (sum.scenes == measured.scenes.size() && name != reference)
      models.push_back({name, sum.error, std::exp(sum.log_cost / static_cast<double>(sum.scenes))});
  std::stable_sort(models.begin(), models.end(), [](const auto& a, const auto& b) { return a.cost < b.cost; });
  return models;
}

RankedModel cheapest_model(const std::vector<RankedModel>& models, const std::vector<std::string>& allowed,
                           double within) {
  return *std::find_if(models.begin(), models.end(), [&](const RankedModel& model) {
    return model.name == reference ||
           (model.error <= within && std::count(allowed.begin(), allowed.end(), model.name) > 0);
  });
}

std::string model_name(const std::optional<thermal::Radiation>& radiation) {
  using Model = thermal::Radiation::Model;
  if (!radiation) return "none";
  switch (radiation->model) {
    case Model::rosseland:
      return "rosseland";
    case Model::p1:
      return "p1";
    case Model::p1_cones:
      return "p1_cones";
    case Model::transfer:
      break;
  }
  return reference;
}

std::string describe(const RadiationChoice& choice) {
  const std::string asked = fmt::format("{}, the cheapest within {:.3g} %", choice.model.name, 100 * choice.within);
  if (choice.model.name == reference) return asked + ": no cheaper model that the case allows keeps it";
  return asked + fmt::format(": off by up to {:.2g} % of wall or heat against {} in {} measured scenes, by {} of {}",
                             100 * choice.model.error, reference, calibration().radiation.scenes.size(),
                             calibration().radiation.commit, calibration().radiation.date);
}

}  // namespace parison::forming
