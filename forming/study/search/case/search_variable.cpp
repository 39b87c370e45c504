// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/case/search_variable.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "core/case/text/case_text.hpp"
#include "core/case/units.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;

/// Steps of a search as a share of the bounds' distance, where none is given.
constexpr double usual_step = 1.0 / 15;

bool same_dimension(const std::string& one, const std::string& other) {
  const auto a = core::parse_unit(one), b = core::parse_unit(other);
  return one == other || (a && b && core::same_exponents(a->dimension, b->dimension));
}

void require_inside(const CaseNode& node, double value, const SearchVariable& variable) {
  const Bounds& bounds = variable.bounds;
  if (value >= bounds.from && value <= bounds.to) return;
  core::refuse(node, fmt::format("{} starts at {}, allowed is a start within the bounds, {} to {}", variable.key,
                                 measure_text(value, bounds.unit), measure_text(bounds.from, bounds.unit),
                                 measure_text(bounds.to, bounds.unit)));
}

/// What the case has at the key of a variable, nothing where it has no value there. A key that the case does not know
/// is refused with those that it knows, at its place in the file of the search.
std::optional<CaseNode> value_in_case(const CaseTable& table, const SearchVariable& variable,
                                      const core::CaseFile& file) {
  try {
    const CaseNode held = core::value_of(file, variable.key);
    if (held.kind == CaseNode::Kind::text || held.kind == CaseNode::Kind::number) return held;
    std::vector<std::string> overrides = file.overrides;
    overrides.push_back(variable.key + '=' + measure_text(variable.bounds.from, variable.bounds.unit));
    read_scene(file.path, "draft", overrides);
  } catch (const core::CaseError& error) {
    const CaseNode& key = table.get("key");
    const std::string text = refusal_text(error), own = variable.key + ": ";
    core::refuse(key, key.key == variable.key && text.rfind(own, 0) == 0 ? text.substr(own.size()) : text);
  }
  return std::nullopt;
}

/// The start that is given, or what the case has.
double start_of(const CaseTable& table, const SearchVariable& variable, const core::CaseFile& file) {
  const CaseNode* given = table.find("start");
  const std::optional<CaseNode> held = value_in_case(table, variable, file);
  if (!given && !held)
    core::refuse(table.node(),
                 fmt::format("the case gives {} no number to start from, allowed is a start", variable.key));
  const CaseNode& place = given ? *given : table.get("from");
  const Measured start = read_measured(given ? *given : *held);
  if (!given && !same_dimension(start.unit, variable.bounds.unit))
    core::refuse(place, fmt::format("the unit \"{}\" was found, allowed is one of what the case has there, \"{}\"",
                                    variable.bounds.unit, start.unit));
  const double value = in_unit(start, variable.bounds.unit, place);
  require_inside(place, value, variable);
  return value;
}

/// The step as a coordinate: a factor where the variable is searched by its logarithm.
double step_of(const CaseTable& table, const SearchVariable& variable) {
  const double whole = variable.high() - variable.low();
  const CaseNode* given = table.find("step");
  if (!given) return usual_step * whole;
  const std::string unit = variable.logarithmic ? "" : variable.bounds.unit == "degC" ? "K" : variable.bounds.unit;
  double step = in_unit(read_measured(*given), unit, *given);
  if (variable.logarithmic) step = std::log(step);
  if (!(step > 0 && step <= whole))
    core::refuse(*given, fmt::format("the step of {} was found to be outside its bounds, allowed is one above zero and "
                                     "at most as wide as they are apart",
                                     variable.key));
  return step;
}

SearchVariable read_variable(const CaseNode& node, const core::CaseFile& file) {
  const CaseTable table(node, {"key", "from", "to", "step", "start", "scale"});
  SearchVariable variable{core::text(table.get("key")), read_bounds(table), 0, 0};
  if (const CaseNode* scale = table.find("scale"))
    variable.logarithmic = core::choice(*scale, {"linear", "logarithmic"}) == 1;
  if (variable.logarithmic && variable.bounds.from <= 0)
    core::refuse(table.get("from"), fmt::format("{} was found, allowed are bounds above zero on a logarithmic scale",
                                                measure_text(variable.bounds.from, variable.bounds.unit)));
  const double start = start_of(table, variable, file);
  variable.start = variable.coordinate(start);
  variable.step = step_of(table, variable);
  return variable;
}

}  // namespace

double SearchVariable::coordinate(double value) const {
  return logarithmic ? std::log(value) : value;
}

double SearchVariable::value(double coordinate) const {
  return logarithmic ? std::exp(coordinate) : coordinate;
}

std::string SearchVariable::text(double coordinate) const {
  return bounds.unit.empty() ? fmt::format("{:.7g}", value(coordinate))
                             : fmt::format("{:.7g} {}", value(coordinate), bounds.unit);
}

std::vector<SearchVariable> read_search_variables(const CaseTable& root, const std::string& file,
                                                  const std::string& case_path,
                                                  const std::vector<std::string>& overrides) {
  const core::CaseFile held = read_case(case_path, overrides);
  std::vector<SearchVariable> variables;
  for (const CaseNode* node : root.tables("variable")) {
    variables.push_back(read_variable(*node, held));
    for (std::size_t i = 0; i + 1 < variables.size(); ++i)
      if (variables[i].key == variables.back().key)
        core::refuse(*node, fmt::format("the key {} was found twice, allowed are different keys", variables[i].key));
  }
  if (variables.empty())
    throw core::CaseError(
        fmt::format("{}: no variable was found, allowed is at least one [[variable]] with a key and its bounds", file));
  return variables;
}

double in_unit(const Measured& measured, const std::string& unit, const CaseNode& node) {
  if (measured.unit == unit) return measured.value;
  const auto from = core::parse_unit(measured.unit), to = core::parse_unit(unit);
  if (!from || !to || !core::same_exponents(from->dimension, to->dimension))
    core::refuse(node, fmt::format("the unit \"{}\" was found, allowed is \"{}\"", measured.unit, unit));
  return measured.value * from->factor / to->factor;
}

}  // namespace parison::forming
