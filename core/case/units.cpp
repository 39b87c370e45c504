// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/units.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

namespace parison::core {
namespace {

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool takes_prefix;
};
constexpr NamedUnit named_units[] = {
    {"m", {1, dimension::length}, true},
    {"in", {0.0254, dimension::length}, false},
    {"mil", {2.54e-5, dimension::length}, false},
    {"g", {1e-3, {0, 1}}, true},
    {"t", {1e3, {0, 1}}, false},
    {"s", {1, dimension::time}, true},
    {"min", {60, dimension::time}, false},
    {"h", {3600, dimension::time}, false},
    {"K", {1, dimension::temperature_difference}, true},
    {"N", {1, dimension::force}, true},
    {"Pa", {1, dimension::pressure}, true},
    {"bar", {1e5, dimension::pressure}, true},
    {"J", {1, {2, 1, -2}}, true},
    {"W", {1, {2, 1, -3}}, true},
    {"P", {0.1, dimension::viscosity}, true},
    {"l", {1e-3, dimension::volume}, true},
    {"rad", {1, dimension::none}, true},
    {"deg", {M_PI / 180, dimension::none}, false},
    {"%", {1e-2, dimension::none}, false},
    {"1", {1, dimension::none}, false},
};

struct Prefix {
  char symbol;
  double factor;
};
constexpr Prefix prefixes[] = {{'G', 1e9},  {'M', 1e6},  {'k', 1e3},  {'h', 1e2}, {'d', 1e-1},
                               {'c', 1e-2}, {'m', 1e-3}, {'u', 1e-6}, {'n', 1e-9}};

struct NamedDimension {
  Dimension dimension;
  const char *name, *example;
  double largest;  ///< in size, SI; far beyond glass and machines, so that no product of them overflows
};
constexpr NamedDimension named_dimensions[] = {
    {dimension::none, "a plain number", "0.5", 1e15},
    {dimension::length, "a length", "2.5 mm", 1e6},
    {dimension::inverse_length, "an inverse length", "150 1/m", 1e15},
    {{2}, "an area", "4 cm2", 1e12},
    {dimension::volume, "a volume", "91.5 cm3", 1e18},
    {dimension::time, "a time", "0.9 s", 1e9},
    {dimension::frequency, "a number in a time", "12 1/min", 1e9},
    {dimension::speed, "a speed", "150 mm/s", 1e6},
    {dimension::acceleration, "an acceleration", "9.81 m/s2", 1e6},
    {{0, 1}, "a mass", "220 g", 1e12},
    {dimension::temperature, "a temperature", "1150 degC", 1e5},
    {dimension::temperature_difference, "a temperature difference", "40 K", 1e6},
    {dimension::density, "a density", "2400 kg/m3", 1e9},
    {dimension::force, "a force", "8 kN", 1e12},
    {dimension::pressure, "a pressure", "0.35 bar", 1e15},
    {dimension::viscosity, "a viscosity", "1e4 Pa.s", 1e30},
    {dimension::surface_tension, "a surface tension", "0.3 N/m", 1e9},
    {dimension::heat_per_area, "a heat on an area", "100 kJ/m2", 1e9},
    {dimension::friction, "a friction coefficient", "1e6 Pa.s/m", 1e30},
    {{2, 1, -2}, "an energy", "33 kJ", 1e18},
    {{2, 1, -3}, "a power", "5 kW", 1e18},
    {dimension::heat_capacity, "a heat capacity", "1300 J/kg/K", 1e12},
    {dimension::conductivity, "a conductivity", "1.3 W/m/K", 1e15},
    {{0, 1, -3}, "a heat flux", "50 kW/m2", 1e18},
    {dimension::conductance, "a heat transfer coefficient", "5000 W/m2/K", 1e18},
};

}  // namespace

bool same_exponents(const Dimension& a, const Dimension& b) {
  return a.length == b.length && a.mass == b.mass && a.time == b.time && a.temperature == b.temperature;
}

namespace {

/// Null for a dimension without a name of its own.
const NamedDimension* find_named(const Dimension& dimension) {
  for (const auto& named : named_dimensions)
    if (same_exponents(named.dimension, dimension) && named.dimension.absolute == dimension.absolute &&
        named.dimension.heat == dimension.heat)
      return &named;
  return nullptr;
}

/// " kg m^-3".
std::string si_unit(const Dimension& dimension) {
  std::string unit;
  const std::pair<const char*, int> parts[] = {
      {"kg", dimension.mass}, {"m", dimension.length}, {"s", dimension.time}, {"K", dimension.temperature}};
  for (const auto& [symbol, exponent] : parts)
    if (exponent == 1)
      unit += fmt::format(" {}", symbol);
    else if (exponent != 0)
      unit += fmt::format(" {}^{}", symbol, exponent);
  return unit;
}

}  // namespace

std::string name_of(const Dimension& dimension) {
  if (const auto* named = find_named(dimension)) return named->name;
  return "a quantity in" + si_unit(dimension);
}

namespace {

std::optional<Unit> find_unit(std::string_view symbol) {
  for (const auto& named : named_units)
    if (named.symbol == symbol) return named.unit;
  for (const auto& prefix : prefixes)
    for (const auto& named : named_units)
      if (named.takes_prefix && !symbol.empty() && symbol.front() == prefix.symbol && symbol.substr(1) == named.symbol)
        return Unit{prefix.factor * named.unit.factor, named.unit.dimension};
  return {};
}

/// "m2", "m^-1", "1": a symbol and a whole exponent.
std::optional<Unit> parse_factor(std::string_view text) {
  if (text == "1") return Unit{};
  const auto digits = text.find_first_of("^-0123456789");
  const auto unit = find_unit(text.substr(0, digits));
  int exponent = 1;
  if (digits != text.npos) {
    text.remove_prefix(digits + (text[digits] == '^'));
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, exponent);
    if (read.ec != std::errc{} || read.ptr != end || std::abs(exponent) > 9) return {};
  }
  if (!unit) return {};
  const auto& d = unit->dimension;
  return Unit{std::pow(unit->factor, exponent),
              {d.length * exponent, d.mass * exponent, d.time * exponent, d.temperature * exponent}};
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  Unit product;
  int sign = 1;
  for (;;) {
    const auto end = text.find_first_of("./* ");
    const auto factor = parse_factor(text.substr(0, end));
    if (!factor) return {};
    product.factor *= sign > 0 ? factor->factor : 1 / factor->factor;
    product.dimension.length += sign * factor->dimension.length;
    product.dimension.mass += sign * factor->dimension.mass;
    product.dimension.time += sign * factor->dimension.time;
    product.dimension.temperature += sign * factor->dimension.temperature;
    if (end == text.npos) return product;
    sign = text[end] == '/' ? -1 : 1;
    text.remove_prefix(end + 1);
  }
}

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::string describe(const Dimension& dimension) {
  if (const auto* named = find_named(dimension)) return fmt::format("{} such as \"{}\"", named->name, named->example);
  return name_of(dimension);
}

double largest_of(const Dimension& dimension) {
  const auto* named = find_named(dimension);
  return named ? named->largest : 1e30;
}

ParsedQuantity parse_quantity(const std::string& text, const Dimension& expected) {
  const auto whole = trimmed(text);
  const auto allowed = fmt::format("allowed is {}", describe(expected));
  double number = 0;
  const auto read = std::from_chars(whole.data(), whole.data() + whole.size(), number);
  if (read.ec == std::errc::result_out_of_range)
    return {0, fmt::format("\"{}\" starts with a number that is too large or too near to zero, {}", text, allowed)};
  if (read.ec != std::errc{} || !std::isfinite(number))
    return {0, fmt::format("\"{}\" does not start with a number, {}", text, allowed)};
  const auto symbol = trimmed(whole.substr(static_cast<std::size_t>(read.ptr - whole.data())));
  const auto in_range = [&](double value) -> ParsedQuantity {
    const double largest = largest_of(expected);
    if (std::abs(value) <= largest) return {value, {}};
    return {0, fmt::format("\"{}\" is too large, {} of up to {:g}{}", text, allowed, largest, si_unit(expected))};
  };
  if (symbol == "degC" && expected.absolute) return in_range(number + zero_celsius);
  if (symbol == "degC") return {0, fmt::format("\"{}\" is a temperature on a scale, {}", text, allowed)};
  const auto unit = symbol.empty() ? Unit{} : parse_unit(symbol).value_or(Unit{0, {}});
  if (unit.factor == 0) return {0, fmt::format("\"{}\" has the unknown unit \"{}\", {}", text, symbol, allowed)};
  if (!same_exponents(unit.dimension, expected))
    return {0, fmt::format("\"{}\" is {}, {}", text, name_of(unit.dimension), allowed)};
  return in_range(number * unit.factor);
}

}  // namespace parison::core
