// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/sweep/design.hpp"

#include <fmt/format.h>

#include <boost/random/sobol.hpp>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

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

namespace {

// The engine is the same everywhere, the distributions of the standard library are not.
using Engine = std::mt19937_64;

/// The 53 bits that a double has, as a number from 0 to below 1.
double share_of(std::uint64_t bits) {
  constexpr double smallest = 1.0 / (std::uint64_t{1} << 53);
  return static_cast<double>(bits >> 11) * smallest;
}

std::vector<std::size_t> shuffled(std::size_t count, Engine& engine) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(share_of(engine()) * static_cast<double>(i))]);
  return order;
}

}  // namespace

DesignPoints latin_hypercube(std::size_t variables, std::size_t runs, std::uint64_t seed) {
  Engine engine(seed);
  DesignPoints points(runs, std::vector<double>(variables));
  for (std::size_t variable = 0; variable < variables; ++variable) {
    const std::vector<std::size_t> part = shuffled(runs, engine);
    for (std::size_t run = 0; run < runs; ++run)
      points[run][variable] = (static_cast<double>(part[run]) + share_of(engine())) / static_cast<double>(runs);
  }
  return points;
}

DesignPoints sobol_sequence(std::size_t variables, std::size_t runs, std::uint64_t seed) {
  boost::random::sobol sequence(variables);
  Engine engine(seed);
  std::vector<std::uint64_t> shift(variables, 0);
  if (seed != 0)
    for (std::uint64_t& bits : shift) bits = engine();
  DesignPoints points(runs, std::vector<double>(variables));
  for (std::vector<double>& point : points)
    for (std::size_t i = 0; i < variables; ++i) point[i] = share_of(sequence() ^ shift[i]);
  return points;
}

std::vector<std::vector<std::size_t>> full_grid(const std::vector<std::size_t>& levels) {
  std::size_t count = 1;
  for (const std::size_t several : levels) count *= several;
  std::vector<std::vector<std::size_t>> rows(count, std::vector<std::size_t>(levels.size()));
  for (std::size_t row = 0; row < count; ++row) {
    std::size_t rest = row;
    for (std::size_t i = levels.size(); i-- > 0;) {
      rows[row][i] = rest % levels[i];
      rest /= levels[i];
    }
  }
  return rows;
}

}  // namespace parison::forming
