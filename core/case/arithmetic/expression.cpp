// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/arithmetic/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/case/case_file.hpp"

namespace parison::core {
namespace {

constexpr int largest_exponent = 30, largest_power = 10;
constexpr const char* power_range = "allowed behind ^ is a whole number, -10 to 10";

/// What is wrong with a formula; leaves the parser at once.
struct Flaw {
  std::string problem;
};

[[noreturn]] void fail(std::string problem) {
  throw Flaw{std::move(problem)};
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

Measure checked(Measure measure) {
  const Dimension& d = measure.dimension;
  for (const int exponent : {d.length, d.mass, d.time, d.temperature})
    if (std::abs(exponent) > largest_exponent)
      fail(fmt::format("powers of units beyond {} were found", largest_exponent));
  if (!std::isfinite(measure.value)) fail("its value is not finite");
  return measure;
}

/// a + b, or a - b where `sign` is -1.
Measure sum(const Measure& a, const Measure& b, int sign) {
  if (!same_exponents(a.dimension, b.dimension))
    fail(
        fmt::format("{} and {} are {}", name_of(a.dimension), name_of(b.dimension), sign > 0 ? "added" : "subtracted"));
  const bool one = a.dimension.absolute, other = b.dimension.absolute;
  if (other && (one ? sign > 0 : sign < 0)) fail("temperatures in degC are added, allowed is a difference in K");
  Measure result = a;
  result.value += sign * b.value;
  result.dimension.absolute = one != other;
  return checked(result);
}

/// a b, or a/b where `sign` is -1.
Measure product(const Measure& a, const Measure& b, int sign) {
  if (a.dimension.absolute || b.dimension.absolute) fail("a temperature in degC is multiplied, allowed is one in K");
  if (sign < 0 && b.value == 0) fail("it divides by zero");
  const Dimension &p = a.dimension, &q = b.dimension;
  return checked({sign > 0 ? a.value * b.value : a.value / b.value,
                  {p.length + sign * q.length, p.mass + sign * q.mass, p.time + sign * q.time,
                   p.temperature + sign * q.temperature}});
}

double plain(const Measure& measure, std::string_view function) {
  if (!same_exponents(measure.dimension, dimension::none))
    fail(fmt::format("{} of {} was found, allowed is that of a plain number or an angle", function,
                     name_of(measure.dimension)));
  return measure.value;
}

Measure root(const Measure& of) {
  const Dimension& d = of.dimension;
  if (of.value < 0) fail("the square root of a negative value was found");
  if (d.length % 2 || d.mass % 2 || d.time % 2 || d.temperature % 2 || d.absolute)
    fail(fmt::format("the square root of {} was found, allowed is that of an area or a plain number", name_of(d)));
  return {std::sqrt(of.value), {d.length / 2, d.mass / 2, d.time / 2, d.temperature / 2}};
}

/// Recursive descent over the text; every function takes what it reads off `rest_`.
class Formula {
 public:
  Formula(std::string_view text, const NamedQuantities& known) : rest_(text), known_(known) {}

  Measure whole() {
    const Measure result = terms();
    if (!rest_.empty()) fail(fmt::format("\"{}\" follows where an operator is allowed", rest_.substr(0, 20)));
    return result;
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }

  bool take(char c) {
    skip_blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    skip_blanks();
    return true;
  }

  Measure terms() {
    if (++depth_ > max_formula_depth) fail(fmt::format("brackets deeper than {} levels were found", max_formula_depth));
    Measure result = factors();
    for (;;)
      if (take('+'))
        result = sum(result, factors(), 1);
      else if (take('-'))
        result = sum(result, factors(), -1);
      else
        break;
    --depth_;
    return result;
  }

  Measure factors() {
    Measure result = factor();
    for (;;)
      if (take('*'))
        result = product(result, factor(), 1);
      else if (take('/'))
        result = product(result, factor(), -1);
      else
        return result;
  }

  Measure factor() {
    bool negative = false;
    while (take('-')) negative = !negative;
    Measure result = power_of_operand();
    if (!negative) return result;
    if (result.dimension.absolute) fail("a temperature in degC is negated, allowed is \"-10 degC\" by itself");
    result.value = -result.value;
    return result;
  }

  /// A value, or one to a whole power.
  Measure power_of_operand() {
    const Measure base = operand();
    if (!take('^')) return base;
    const bool negative = take('-');
    int exponent = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), exponent);
    if (read.ec != std::errc{} || exponent > largest_power) fail(power_range);
    rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
    skip_blanks();
    if (!rest_.empty() && (rest_.front() == '.' || rest_.front() == '^')) fail(power_range);
    Measure result{1, {}};
    for (int i = 0; i < exponent; ++i) result = product(result, base, negative ? -1 : 1);
    return result;
  }

  Measure operand() {
    if (take('(')) return closed(terms());
    if (!rest_.empty() && (is_digit(rest_.front()) || rest_.front() == '.')) return number();
    if (!rest_.empty() && is_letter(rest_.front())) return named();
    if (rest_.empty()) fail("it ends where a value is allowed");
    fail(fmt::format("\"{}\" was found where a value is allowed", rest_.substr(0, 20)));
  }

  Measure closed(const Measure& inside) {
    if (!take(')')) fail("a closing bracket is missing");
    return inside;
  }

  Measure number() {
    double value = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (read.ec != std::errc{} || !std::isfinite(value)) fail("a number is too large or too near to zero");
    rest_.remove_prefix(static_cast<std::size_t>(read.ptr - rest_.data()));
    skip_blanks();
    if (rest_.empty() || !(is_letter(rest_.front()) || rest_.front() == '%')) return {value, {}};
    const std::string_view symbol = unit();
    skip_blanks();
    if (!rest_.empty() && rest_.front() == '^')
      fail("^ follows a number with a unit, allowed are brackets around the two");
    if (symbol == "degC") return checked({value + zero_celsius, dimension::temperature});
    const Unit unit = *parse_unit(symbol);
    return checked({value * unit.factor, unit.dimension});
  }

  std::optional<Measure> find(std::string_view name) const { return known_.find ? known_.find(name) : std::nullopt; }

  bool divides_by_name(std::string_view symbol) const {
    for (auto at = symbol.find('/'); at != symbol.npos; at = symbol.find('/', at + 1)) {
      const auto factor = symbol.substr(at + 1);
      if (find(factor.substr(0, factor.find_first_of("/.^")))) return true;
    }
    return false;
  }

  /// Takes the longest unit; what is divided by a known name is not part of it.
  std::string_view unit() {
    std::size_t size = 0;
    const auto belongs = [](char c) {
      return is_letter(c) || is_digit(c) || c == '%' || c == '^' || c == '/' || c == '.';
    };
    while (size < rest_.size() && belongs(rest_[size])) ++size;
    const std::string_view all = rest_.substr(0, size);
    for (std::string_view symbol = all; !symbol.empty();) {
      const auto last = symbol.find_last_of("/.");
      if (!divides_by_name(symbol) && (symbol == "degC" || parse_unit(symbol))) {
        rest_.remove_prefix(symbol.size());
        return symbol;
      }
      symbol = last == symbol.npos ? std::string_view{} : symbol.substr(0, last);
    }
    if (find(all.substr(0, all.find_first_of("/.^"))))
      fail(fmt::format("\"{}\" follows a number, allowed is a * between them", all));
    fail(fmt::format("it has the unknown unit \"{}\"", all));
  }

  Measure named() {
    std::size_t size = 0;
    while (size < rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]))) ++size;
    const std::string_view name = rest_.substr(0, size);
    rest_.remove_prefix(size);
    if (take('(')) return function(name);
    if (name == "pi") return {M_PI, {}};
    if (const auto found = find(name)) return *found;
    fail(fmt::format("there is no dimension \"{}\"{}, allowed {}", name, did_you_mean(std::string(name), known_.names),
                     known_.names.empty() ? "are those of a table [dimension]"
                                          : fmt::format("are {}", fmt::join(known_.names, ", "))));
  }

  Measure function(std::string_view name) {
    const Measure first = terms();
    if (name == "min" || name == "max") {
      if (!take(',')) fail(fmt::format("{} has one value, allowed are two", name));
      const Measure second = terms();
      if (!same_exponents(first.dimension, second.dimension) || first.dimension.absolute != second.dimension.absolute)
        fail(fmt::format("{} and {} are compared", name_of(first.dimension), name_of(second.dimension)));
      return closed((first.value < second.value) == (name == "min") ? first : second);
    }
    closed(first);
    if (name == "sqrt") return root(first);
    if (name == "sin") return {std::sin(plain(first, name)), {}};
    if (name == "cos") return {std::cos(plain(first, name)), {}};
    if (name == "tan") return {std::tan(plain(first, name)), {}};
    if (name == "exp") return checked({std::exp(plain(first, name)), {}});
    fail(fmt::format("there is no function \"{}\", allowed are min, max, sqrt, exp, sin, cos, tan", name));
  }

  std::string_view rest_;
  const NamedQuantities& known_;
  int depth_ = 0;
};

}  // namespace

ParsedMeasure parse_formula(std::string_view text, const NamedQuantities& known) {
  if (text.size() > max_formula_length)
    return {{}, fmt::format("a formula of {} signs was found, allowed are up to {}", text.size(), max_formula_length)};
  try {
    return {Formula(text, known).whole(), {}};
  } catch (const Flaw& flaw) {
    return {{}, fmt::format("\"{}\" is no quantity: {}", text, flaw.problem)};
  }
}

ParsedQuantity parse_formula_as(std::string_view text, const Dimension& expected, const NamedQuantities& known,
                                std::string_view unit) {
  auto [measure, problem] = parse_formula(text, known);
  if (!problem.empty()) return {0, problem};
  if (const auto of_plain = unit.empty() ? std::nullopt : parse_unit(unit);
      of_plain && same_exponents(measure.dimension, dimension::none))
    measure = {measure.value * of_plain->factor, of_plain->dimension};
  if (!same_exponents(measure.dimension, expected) || (measure.dimension.absolute && !expected.absolute))
    return {0, fmt::format("\"{}\" is {}, allowed is {}", text, name_of(measure.dimension), describe(expected))};
  const double largest = largest_of(expected);
  if (!(std::abs(measure.value) <= largest))
    return {0, fmt::format("\"{}\" is too large, allowed is {} of up to {:g} in SI units", text, describe(expected),
                           largest)};
  return {measure.value, {}};
}

}  // namespace parison::core
