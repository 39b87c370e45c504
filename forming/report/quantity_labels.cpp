// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/quantity_labels.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace parison::forming {
namespace {

using Label = std::pair<const char*, const char*>;

constexpr std::array labels{Label{"thickness_mean", "wall thickness, mean"},
                            Label{"thickness_min", "wall thickness, least"},
                            Label{"thickness_min_at", "thinnest place, share of the outer side"},
                            Label{"glass_mean", "glass temperature, mean"},
                            Label{"glass_skin", "glass temperature, outer surface"},
                            Label{"extent_r_max", "largest radius"},
                            Label{"extent_z_min", "lowest z"},
                            Label{"extent_z_max", "highest z"},
                            Label{"temper_number", "real temper number of the base"},
                            Label{"residual_tension", "residual tension, largest"},
                            Label{"residual_tension_surface", "residual tension, surface"},
                            Label{"cooling_tension_surface", "tension while cooling, surface"},
                            Label{"cooling_time", "take-out to the end"}};

/// Of a tool or a stage, whose name follows.
constexpr std::array prefixes{Label{"heat_", "heat into "}, Label{"time_", "duration of "},
                              Label{"peak_force_", "largest force of "}};

std::string words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

std::string quantity_label(const std::string& name) {
  for (const auto& [known, label] : labels)
    if (name == known) return label;
  for (const auto& [prefix, label] : prefixes)
    if (name.rfind(prefix, 0) == 0) return label + words(name.substr(std::string(prefix).size()));
  return words(name);
}

}  // namespace parison::forming
