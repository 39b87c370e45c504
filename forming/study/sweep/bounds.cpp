// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/sweep/bounds.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/case/given_file.hpp"
#include "core/case/number.hpp"

namespace parison::forming {

using core::CaseNode;

Measured read_measured(const CaseNode& node) {
  if (node.kind == CaseNode::Kind::number) return {node.number, ""};
  const std::string& text = core::text(node);
  const auto read = core::leading_number(text);
  if (!read || read->rest.find_first_of("()\"'") != read->rest.npos)
    core::refuse(node, fmt::format("\"{}\" was found, allowed is a number with its unit, such as \"440 degC\"", text));
  return {read->value, std::string(read->rest)};
}

std::string measure_text(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.9g}", value) : fmt::format("{:.9g} {}", value, unit);
}

Bounds read_bounds(const core::CaseTable& table) {
  const Measured from = read_measured(table.get("from")), to = read_measured(table.get("to"));
  if (from.unit != to.unit)
    core::refuse(table.get("to"),
                 fmt::format("the unit \"{}\" was found, allowed is that of from, \"{}\"", to.unit, from.unit));
  if (!(from.value < to.value))
    core::refuse(table.get("to"), fmt::format("{} was found, allowed is more than from, {}",
                                              measure_text(to.value, to.unit), measure_text(from.value, from.unit)));
  return {from.value, to.value, from.unit};
}

}  // namespace parison::forming
