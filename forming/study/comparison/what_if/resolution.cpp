// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/case/case_error.hpp"
#include "core/case/number.hpp"
#include "core/case/units.hpp"
#include "core/math/numbers.hpp"
#include "forming/report/quantity_labels.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

constexpr const char* usual_quantity = "thickness_min";
constexpr double first_factor = 2;  ///< of the draft preset's edges and steps
/// Bars shrink like edges and steps, as far as scatter lets them; the next round aims below the target.
constexpr double aim = 0.75, least_refinement = 1.3, most_refinement = 2.5;
constexpr int most_rounds = 6;
/// Bars that shrink with less than this power of edges and steps are held by something else, such as scatter.
constexpr double least_order = 0.5;
/// CPU time goes with such powers of one over edges and steps.
constexpr double least_cost_order = 2, most_cost_order = 4;
/// What is asked for may take so many times the CPU time of the last round, from the second on.
constexpr double most_effort = 100;

/// Size of the units of quantities, SI, and their dimensions.
struct QuantityUnit {
  double size;
  core::Dimension dimension;
};
const std::map<std::string, QuantityUnit>& quantity_units() {
  static const std::map<std::string, QuantityUnit> units{{"mm", {1e-3, core::dimension::length}},
                                                         {"s", {1, core::dimension::time}},
                                                         {"N", {1, core::dimension::force}},
                                                         {"degC", {1, core::dimension::temperature_difference}}};
  return units;
}

[[noreturn]] void refuse_size(const std::string& wanted, const std::string& problem) {
  throw core::CaseError(
      fmt::format("--resolve: \"{}\" was found, {}; allowed are a length of the wall such as \"0.02 mm\" or "
                  "QUANTITY=SIZE with a quantity of the case in its unit",
                  wanted, problem));
}

/// The size in the unit of the quantity.
double read_size(const std::string& size, const std::string& unit, const std::string& wanted) {
  double value = core::none;
  if (const auto known = quantity_units().find(unit); known != quantity_units().end()) {
    const core::ParsedQuantity parsed = core::parse_quantity(size, known->second.dimension);
    if (!parsed.problem.empty()) refuse_size(wanted, parsed.problem);
    value = parsed.value / known->second.size;
  } else {
    const auto read = core::leading_number(size);
    if (!read || (!read->rest.empty() && read->rest != unit))
      refuse_size(wanted, fmt::format("but the unit of this quantity is {}", unit));
    value = read->value;
  }
  if (!(value > 0)) refuse_size(wanted, "which is not above zero");
  return value;
}

/// To two figures that are not below it.
double rounded_up(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  return digit * std::ceil(value / digit * (1 - 1e-12));
}

}  // namespace

ResolutionControl::ResolutionControl(const std::string& wanted, const std::vector<Quantity>& possible)
    : wanted_(wanted),
      factor_(core::none),
      next_factor_(first_factor),
      target_(core::none),
      bar_(core::none),
      cpu_(core::none) {
  const auto equals = wanted.find('=');
  quantity_ = equals == wanted.npos ? usual_quantity : wanted.substr(0, equals);
  if (const std::string problem = unknown_quantity(quantity_, possible); !problem.empty())
    throw core::CaseError("--resolve: " + problem);
  for (const Quantity& one : possible)
    if (one.name == quantity_) unit_ = one.unit, least_ = std::fmax(0, least_bar * one.scale);
  target_ = read_size(equals == wanted.npos ? wanted : wanted.substr(equals + 1), unit_, wanted_);
  if (const std::string problem = too_small(); !problem.empty()) throw core::CaseError("--resolve: " + problem);
}

std::string ResolutionControl::accuracy() const {
  return fmt::format("draft coarser {:.3g}", next_factor_);
}

double ResolutionControl::expected_bar() const {
  return bar_ * std::pow(next_factor_ / factor_, order_);
}

double ResolutionControl::expected_cpu() const {
  return cpu_ * std::pow(factor_ / next_factor_, cost_order_);
}

void ResolutionControl::learn_orders(double bar_before, double factor_before, double cpu_before) {
  const double finer = std::log(factor_before / factor_);
  if (const double order = std::log(bar_before / bar_) / finer; std::isfinite(order))
    order_ = std::clamp(order, least_order, 1.0);
  if (const double order = std::log(cpu_ / cpu_before) / finer; std::isfinite(order))
    cost_order_ = std::clamp(order, least_cost_order, most_cost_order);
}

void ResolutionControl::judge_effort(double bar_before, double factor_before) {
  const double finer = factor_before / factor_, order = std::log(bar_before / bar_) / std::log(finer);
  const double effort = std::pow(bar_ / target_, cost_order_ / order_);
  if (order < least_order)
    gives_up_ = fmt::format(
        "edges and steps {:.2g} times finer took the bars from {:.3g} to {:.3g} {}, where about {:.3g} was to be "
        "expected: finer rounds are not likely to get to {:.3g}",
        finer, bar_before, bar_, unit_, bar_before / finer, target_);
  else if (effort > most_effort)
    gives_up_ = fmt::format(
        "as the bars went from {:.3g} to {:.3g} {}, {:.3g} would take some {:.2g} times the CPU time of the last "
        "round, "
        "more than {:g} times",
        bar_before, bar_, unit_, target_, effort, most_effort);
}

void ResolutionControl::add(const Comparison& comparison, double cpu_seconds) {
  if (const std::string problem = unknown_quantity(quantity_, comparison.base.quantities.values); !problem.empty())
    throw core::CaseError("--resolve: the run of the base has no such result: " + problem);
  const std::vector<std::string> before = std::move(without_bar_);
  const double bar_before = bar_, factor_before = factor_, cpu_before = cpu_;
  without_bar_.clear();
  bar_ = core::none;
  for (const ComparedRun& other : comparison.others) {
    if (other.unchanged) continue;
    const Difference* row = find_row(other, quantity_);
    const double bar = row ? row->bar : core::none;
    if (row) least_ = std::max(least_, least_bar * row->scale);
    if (!std::isfinite(bar)) without_bar_.push_back(other.label);
    bar_ = std::fmax(bar_, bar);
  }
  factor_ = next_factor_;
  cpu_ = cpu_seconds;
  ++rounds_;
  learn_orders(bar_before, factor_before, cpu_before);
  const bool are_known = std::isfinite(bar_before) && std::isfinite(bar_) && before.empty() && without_bar_.empty();
  if (are_known && !reached()) judge_effort(bar_before, factor_before);
  // Runs that stop at coarse edges may end at finer ones, but hardly at those beyond draft where they stopped before.
  const bool stop_again = !without_bar_.empty() && without_bar_ == before && factor_ <= 1 && !(bar_ > target_);
  out_of_reach_ = stop_again || !too_small().empty() || !gives_up_.empty();
  const double finer = std::isfinite(bar_)
                           ? std::clamp(std::pow(bar_ / (aim * target_), 1 / order_), least_refinement, most_refinement)
                           : most_refinement;
  next_factor_ = factor_ / finer;
}

std::string ResolutionControl::label() const {
  return quantity_label(quantity_);
}

std::string ResolutionControl::too_small() const {
  if (!(target_ < least_ * (1 - core::round_off))) return {};
  return fmt::format(
      "\"{}\" was found, but no error bar of {} is below {:.2g} {}, {:g} of its scale; allowed are sizes "
      "from there on",
      wanted_, label(), rounded_up(least_), unit_, least_bar);
}

bool ResolutionControl::reached() const {
  return bar_ <= target_ * (1 + core::round_off) && without_bar_.empty();
}

bool ResolutionControl::finished() const {
  return reached() || out_of_reach_ || rounds_ >= most_rounds || next_factor_ < min_coarsening;
}

}  // namespace parison::forming
