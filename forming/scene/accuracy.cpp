// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/accuracy.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/case/case_error.hpp"
#include "core/case/number.hpp"
#include "forming/scene/calibration.hpp"

namespace parison::forming {
namespace {

namespace dimension = core::dimension;

constexpr std::array preset_names{"draft", "standard", "fine"};
constexpr const char* coarser_word = " coarser ";
constexpr double min_target = 0.0013, max_target = 0.07;  ///< at the levels 2.9 and -2

std::size_t nearest_preset(double level) {
  return static_cast<std::size_t>(std::clamp(std::floor(level + 0.5), 0.0, double(preset_names.size() - 1)));
}

/// A whole text as a number above zero, 0 where it is none.
double number(const std::string& text) {
  const auto value = core::parse_number<double>(text);
  return value && std::isfinite(*value) && *value > 0 ? *value : 0;
}

[[noreturn]] void refuse(const std::string& text) {
  throw core::CaseError(
      fmt::format("accuracy: \"{}\" was found, allowed are draft, standard, fine or an error such as "
                  "\"0.5%\", with \" coarser 1.5\" behind it or without",
                  text));
}

/// Values of a setting at the presets.
const auto& levels_of(double Accuracy::*value) {
  return std::find_if(settings().begin(), settings().end(), [&](const Setting& s) { return s.value == value; })->levels;
}

double law_level(const ErrorLaw& law, double target) {
  return std::log2(law.at_draft / target) / law.order;
}

double read_target(const std::string& text) {
  const double target = number(text.substr(0, text.find_last_not_of(" %") + 1)) / 100;
  if (target <= 0) refuse(text);
  constexpr double rounding = 1e-12;
  if (target > max_target * (1 + rounding) || target < min_target * (1 - rounding))
    throw core::CaseError(fmt::format("accuracy: \"{}\" was found, allowed are errors from {:g}% to {:g}%", text,
                                      100 * min_target, 100 * max_target));
  return target;
}

}  // namespace

const std::vector<Setting>& settings() {
  using A = Accuracy;
  static const std::vector<Setting> all = {
      {"surface_size", &A::surface_size, dimension::length, "mm", 1e-3, 1, {1.6e-3, 1e-3, 0.6e-3}, 1e-7, 0.1},
      {"skin_size", &A::skin_size, dimension::length, "mm", 1e-3, 1, {0.7e-3, 0.4e-3, 0.22e-3}, 1e-7, 0.1},
      {"viscosity_per_edge", &A::viscosity_per_edge, dimension::none, "", 1, 1, {5, 2.9, 1.6}, 0.01, 1e6},
      {"elements_across", &A::elements_across, dimension::none, "", 1, -0.6, {2, 3, 4.5}, 0.5, 100},
      {"tool_contact_size", &A::tool_contact_size, dimension::length, "mm", 1e-3, 1, {3e-3, 2e-3, 1.2e-3}, 1e-7, 0.5},
      {"strain_per_step", &A::strain_per_step, dimension::none, "", 1, 1, {0.3, 0.15, 0.075}, 1e-4, 2},
      {"landing_per_step", &A::landing_per_step, dimension::none, "", 1, 0, {0.7, 0.7, 0.7}, 0.01, 1e6},
      {"work_per_step", &A::work_per_step, dimension::none, "", 1, 3, {6e-5, 1.5e-5, 3.3e-6}, 1e-9, 1e6},
      {"temperature_tolerance",
       &A::temperature_tolerance,
       dimension::temperature_difference,
       "K",
       1,
       2,
       {1, 0.2, 0.05},
       1e-7,
       100},
      {"temperature_per_step",
       &A::temperature_per_step,
       dimension::temperature_difference,
       "K",
       1,
       1,
       {40, 20, 10},
       1e-3,
       2000},
      {"light_rays", &A::light_rays, dimension::none, "", 1, -1, {2000, 3000, 4500}, 100, 1e7},
      {"max_step", &A::max_step, dimension::time, "s", 1, 1, {0.2, 0.1, 0.05}, 1e-9, 1e6},
      {"initial_step", &A::initial_step, dimension::time, "s", 1, 0, {1e-3, 1e-3, 1e-3}, 1e-9, 1e6},
      {"min_step", &A::min_step, dimension::time, "s", 1, 0, {1e-6, 1e-6, 1e-6}, 1e-12, 1e6},
      {"motion_tolerance",
       &A::motion_tolerance,
       dimension::length,
       "mm",
       1e-3,
       2,
       {0.05e-3, 0.025e-3, 6.25e-6},
       1e-10,
       0.01},
      {"max_cells", &A::max_cells, dimension::none, "", 1, -2, {2e4, 3e4, 4.5e4}, 100, 1e7},
      {"quality_floor", &A::quality_floor, dimension::none, "", 1, 0, {0.04, 0.1, 0.1}, 1e-4, 0.9}};
  return all;
}

Accuracy accuracy_at(double level) {
  const std::size_t nearest = nearest_preset(level), from = level < 1 ? 0 : 1;
  Accuracy accuracy{};
  for (const Setting& setting : settings()) {
    const double low = setting.levels[from], high = setting.levels[from + 1];
    accuracy.*setting.value = low == high || (level == std::floor(level) && level == double(nearest))
                                  ? setting.levels[nearest]
                                  : low * std::pow(high / low, level - double(from));
  }
  // Beyond the presets it would leave what a mesh can have.
  const auto& floors = levels_of(&Accuracy::quality_floor);
  accuracy.quality_floor = std::clamp(accuracy.quality_floor, floors.front(), floors.back());
  return accuracy;
}

Accuracy coarsened(Accuracy accuracy, double factor) {
  for (const Setting& setting : settings()) accuracy.*setting.value *= std::pow(factor, setting.order);
  accuracy.initial_step = std::min(accuracy.initial_step, accuracy.max_step);
  return accuracy;
}

double expected_error(double level) {
  return std::max(calibration().error_law.thickness.at(level), calibration().error_law.heat.at(level));
}

double level_for(double target) {
  return std::max(law_level(calibration().error_law.thickness, target),
                  law_level(calibration().error_law.heat, target));
}

AccuracyChoice read_accuracy(const std::string& text) {
  const auto at = text.find(coarser_word);
  const std::string base = text.substr(0, at);
  AccuracyChoice choice;
  if (at != text.npos) choice.coarsening_factor = number(text.substr(at + std::strlen(coarser_word)));
  if (choice.coarsening_factor == 0) refuse(text);
  if (choice.coarsening_factor < min_coarsening || choice.coarsening_factor > max_coarsening)
    throw core::CaseError(fmt::format("accuracy: \"{}\" was found, allowed are factors from {:g} to {:g}", text,
                                      min_coarsening, max_coarsening));
  const auto preset = std::find(preset_names.begin(), preset_names.end(), base);
  if (preset != preset_names.end()) {
    choice.level = double(preset - preset_names.begin());
  } else if (!base.empty() && base.back() == '%') {
    choice.target = read_target(base);
    choice.level = level_for(*choice.target);
  } else {
    refuse(text);
  }
  return choice;
}

std::string coarsened_text(const std::string& text, double factor) {
  return fmt::format("{}{}{:.12g}", text.substr(0, text.find(coarser_word)), coarser_word,
                     factor * read_accuracy(text).coarsening_factor);
}

Accuracy accuracy_preset(const std::string& text) {
  const AccuracyChoice choice = read_accuracy(text);
  const Accuracy accuracy = accuracy_at(choice.level);
  return choice.coarsening_factor == 1 ? accuracy : coarsened(accuracy, choice.coarsening_factor);
}

}  // namespace parison::forming
