// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "forming/report/quantity_labels.hpp"
#include "forming/scene/accuracy.hpp"

namespace parison::forming {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr const char* usual_quantity = "thickness_min";
constexpr double first_factor = 2;  ///< of the draft preset's edges and steps
/// Bars shrink like edges and steps, as far as scatter lets them; the next round aims below the target.
constexpr double aim = 0.75, least_refinement = 1.3, most_refinement = 2.5;
constexpr int most_rounds = 6;
constexpr double round_off = 1e-9;

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
  double value = none;
  if (const auto known = quantity_units().find(unit); known != quantity_units().end()) {
    const core::ParsedQuantity parsed = core::parse_quantity(size, known->second.dimension);
    if (!parsed.problem.empty()) refuse_size(wanted, parsed.problem);
    value = parsed.value / known->second.size;
  } else {
    char* end = nullptr;
    value = std::strtod(size.c_str(), &end);
    std::string rest = end;
    rest.erase(std::remove(rest.begin(), rest.end(), ' '), rest.end());
    if (end == size.c_str() || (!rest.empty() && rest != unit))
      refuse_size(wanted, fmt::format("but the unit of this quantity is {}", unit));
  }
  if (!(value > 0)) refuse_size(wanted, "which is not above zero");
  return value;
}

/// The row of a quantity of a variant; null where it has none.
const Difference* row_of(const ComparedRun& other, const std::string& quantity) {
  if (other.result)
    for (const Difference& row : other.result->quantities)
      if (row.name == quantity) return &row;
  return nullptr;
}

/// To two figures that are not below it.
double rounded_up(double value) {
  const double digit = std::pow(10, std::floor(std::log10(value)) - 1);
  return digit * std::ceil(value / digit * (1 - 1e-12));
}

}  // namespace

ResolutionControl::ResolutionControl(const std::string& wanted, const std::vector<Quantity>& possible)
    : wanted_(wanted), factor_(none), next_factor_(first_factor), target_(none), bar_(none) {
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

void ResolutionControl::add(const Comparison& comparison) {
  if (const std::string problem = unknown_quantity(quantity_, comparison.base.quantities.values); !problem.empty())
    throw core::CaseError("--resolve: the run of the base has no such result: " + problem);
  const std::vector<std::string> before = std::move(without_bar_);
  without_bar_.clear();
  bar_ = none;
  for (const ComparedRun& other : comparison.others) {
    if (other.unchanged) continue;
    const Difference* row = row_of(other, quantity_);
    const double bar = row ? row->bar : none;
    if (row) least_ = std::max(least_, least_bar * row->scale);
    if (!std::isfinite(bar)) without_bar_.push_back(other.label);
    bar_ = std::fmax(bar_, bar);
  }
  factor_ = next_factor_;
  ++rounds_;
  // Runs that stop at coarse edges may end at finer ones, but hardly at those beyond draft where they stopped before.
  const bool stop_again = !without_bar_.empty() && without_bar_ == before && factor_ <= 1 && !(bar_ > target_);
  out_of_reach_ = stop_again || !too_small().empty();
  const double finer =
      std::isfinite(bar_) ? std::clamp(bar_ / (aim * target_), least_refinement, most_refinement) : most_refinement;
  next_factor_ = factor_ / finer;
}

std::string ResolutionControl::label() const {
  return quantity_label(quantity_);
}

std::string ResolutionControl::too_small() const {
  if (!(target_ < least_ * (1 - round_off))) return {};
  return fmt::format(
      "\"{}\" was found, but no error bar of {} is below {:.2g} {}, {:g} of its scale; allowed are sizes "
      "from there on",
      wanted_, label(), rounded_up(least_), unit_, least_bar);
}

bool ResolutionControl::reached() const {
  return bar_ <= target_ * (1 + round_off) && without_bar_.empty();
}

bool ResolutionControl::finished() const {
  return reached() || out_of_reach_ || rounds_ >= most_rounds || next_factor_ < min_coarsening;
}

}  // namespace parison::forming
