// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "forming/scene/law_names.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

/// The keys of an interface whatever its law, with the law's own.
CaseTable with_keys(const CaseNode& node, std::initializer_list<const char*> own) {
  std::vector<std::string> keys = {"tools", "law", "transition_gap"};
  keys.insert(keys.end(), own.begin(), own.end());
  return CaseTable(node, keys);
}

contact::PressureViscosityConductance read_pressure_viscosity(const CaseNode& node) {
  const auto table = with_keys(node, {"h0", "h1", "p_ref", "eta_ref", "a", "b"});
  contact::PressureViscosityConductance law;
  law.h0 = core::positive(table.get("h0"), dimension::conductance);
  law.h1 = core::positive(table.get("h1"), dimension::conductance);
  if (law.h1 < law.h0)
    core::refuse(table.get("h1"), fmt::format("\"{}\" is below h0, allowed is h1 not below h0", table.get("h1").text));
  law.p_ref = core::positive(table.get("p_ref"), dimension::pressure);
  law.eta_ref = core::positive(table.get("eta_ref"), dimension::viscosity);
  law.a = core::not_negative(table.get("a"), dimension::none);
  law.b = core::not_negative(table.get("b"), dimension::none);
  return law;
}

/// Increasing quantities above zero.
std::vector<double> read_axis(const CaseNode& node, const core::Dimension& dimension) {
  std::vector<double> axis;
  for (const auto& item : core::list(node)) {
    axis.push_back(core::positive(item, dimension));
    if (axis.size() > 1 && !(axis.back() > axis[axis.size() - 2]))
      core::refuse(
          item, fmt::format("\"{}\" is not greater than the entry before, allowed are increasing entries", item.text));
  }
  if (axis.empty()) core::refuse(node, "an empty list was found, allowed is at least one entry");
  return axis;
}

void require_size(const CaseNode& node, std::size_t size, const char* one_for) {
  if (core::list(node).size() != size)
    core::refuse(node, fmt::format("{} members were found, allowed is one for each of the {} {}", node.items.size(),
                                   size, one_for));
}

contact::TableConductance read_table(const CaseNode& node) {
  const auto table = with_keys(node, {"pressure", "viscosity", "h"});
  contact::TableConductance law;
  law.pressure = read_axis(table.get("pressure"), dimension::pressure);
  law.viscosity = read_axis(table.get("viscosity"), dimension::viscosity);
  const auto& rows = table.get("h");
  require_size(rows, law.pressure.size(), "pressures");
  for (const auto& row : rows.items) {
    require_size(row, law.viscosity.size(), "viscosities");
    for (const auto& item : row.items) law.h.push_back(core::positive(item, dimension::conductance));
  }
  return law;
}

/// Where one of two keys is given: the first that is.
const CaseNode& given_of(const CaseTable& table, const char* first, const char* second) {
  const CaseNode* node = table.find(first);
  return node ? *node : table.get(second);
}

/// Published constants, or such that lie within what is published (contact/README.md): in force where none are given.
contact::GapConductance published_gap() {
  contact::GapConductance law;
  law.touch_gap = 0.25e-6;
  law.open_gap = 40e-6;
  law.opening_time = 0.25;
  law.closing = 1;
  law.accommodation = 0.9;
  return law;
}

contact::GapConductance read_gap(const CaseNode& node) {
  const auto table = with_keys(node, {"touch_gap", "open_gap", "opening_time", "closing", "accommodation"});
  contact::GapConductance law = published_gap();
  if (const auto* item = table.find("touch_gap")) law.touch_gap = core::positive(*item, dimension::length);
  if (const auto* item = table.find("open_gap")) law.open_gap = core::positive(*item, dimension::length);
  if (law.open_gap < law.touch_gap)
    core::refuse(given_of(table, "open_gap", "touch_gap"),
                 fmt::format("an open_gap of {:g} um is below the touch_gap of {:g} um, allowed is one not below it",
                             1e6 * law.open_gap, 1e6 * law.touch_gap));
  if (const auto* item = table.find("opening_time")) law.opening_time = core::positive(*item, dimension::time);
  if (const auto* item = table.find("closing")) law.closing = core::not_negative(*item, dimension::none);
  if (const auto* item = table.find("accommodation")) law.accommodation = core::positive(*item, dimension::none);
  if (law.accommodation > 1)
    core::refuse(table.get("accommodation"), fmt::format("{:g} was found, allowed is above 0 to 1", law.accommodation));
  return law;
}

/// Exchange of grey light between two faces; 0 where the light in bands counts it, or a face has no emissivity.
double exchange_emissivity(const Scene& scene, const Tool& tool) {
  const double glass = scene.glass.emissivity;
  return scene.has_light() || glass == 0 || tool.emissivity == 0 ? 0 : 1 / (1 / glass + 1 / tool.emissivity - 1);
}

/// An interface of any law.
CaseTable interface_table(const CaseNode& node) {
  return with_keys(node, {"h", "h0", "h1", "p_ref", "eta_ref", "a", "b", "pressure", "viscosity", "touch_gap",
                          "open_gap", "opening_time", "closing", "accommodation"});
}

contact::ConductanceLaw read_law(const CaseNode& node, bool with_flow) {
  const auto table = interface_table(node);
  const int law = core::choice(table.get("law"), {law_names.begin(), law_names.end()});
  if (law == 3) return read_gap(node);
  if (law > 0 && !with_flow)
    core::refuse(table.get("law"),
                 "the glass does not flow and has no contact pressure, allowed are \"constant\" and \"gap\"");
  if (law == 1) return read_pressure_viscosity(node);
  if (law == 2) return read_table(node);
  return contact::ConstantConductance{core::positive(with_keys(node, {"h"}).get("h"), dimension::conductance)};
}

}  // namespace

std::vector<Interface> read_interfaces(const CaseNode& node, const Scene& scene) {
  // A property of the layer of air, so that it does not grow with the bodies: a gap as wide passes no contact heat.
  constexpr double default_transition_gap = 1e-4;  // m
  const auto law = read_law(node, scene.has_flow());
  const auto table = interface_table(node);
  double width = default_transition_gap;
  if (const auto* item = table.find("transition_gap")) width = core::positive(*item, dimension::length);
  std::vector<Interface> interfaces;
  for (const auto& item : core::list(table.get("tools"))) {
    const Index tool = core::choice(item, tool_names(scene));
    if (!scene.has_heat() || !scene.tools[tool].thermal)
      core::refuse(item, fmt::format("\"{}\" or the glass carries no heat, allowed are tools that do", item.text));
    const auto is_this = [&](const Interface& other) { return other.tool == tool; };
    for (const auto* known : {&std::as_const(scene.interfaces), &std::as_const(interfaces)})
      if (std::any_of(known->begin(), known->end(), is_this))
        core::refuse(item, fmt::format("\"{}\" has an interface already, allowed is one", item.text));
    interfaces.push_back({tool, law, width});
    if (auto* gap = std::get_if<contact::GapConductance>(&interfaces.back().law)) {
      gap->exchange_emissivity = exchange_emissivity(scene, scene.tools[tool]);
      if (gap->open_gap >= width)
        core::refuse(given_of(table, "open_gap", "transition_gap"),
                     fmt::format("an open_gap of {:g} mm is not below the transition gap of {:g} mm, beyond which a "
                                 "contact is over; allowed is less",
                                 1e3 * gap->open_gap, 1e3 * width));
    }
  }
  return interfaces;
}

}  // namespace parison::forming
