// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "forming/report/model_bars.hpp"
#include "forming/report/quantity_labels.hpp"
#include "forming/study/comparison/remarks.hpp"
#include "forming/study/comparison/same_case.hpp"

namespace parison::forming {
namespace {

constexpr const char* thinnest = "thickness_min";

/// So many digits that the bar, or the smaller of the values, shows two.
int digits_for(double size) {
  if (!(size > 0) || !std::isfinite(size)) return 4;
  return std::clamp(1 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
}

std::string number(double value, int digits, bool sign = false) {
  if (!std::isfinite(value)) return "-";
  if (std::abs(value) < 0.5 * std::pow(10, -digits)) value = 0;  // and no sign of a zero
  return sign ? fmt::format("{:+.{}f}", value, digits) : fmt::format("{:.{}f}", value, digits);
}

/// Width of the column of labels.
int label_width(const std::vector<Difference>& rows) {
  std::size_t width = 22;
  for (const Difference& row : rows) width = std::max(width, quantity_label(row.name).size());
  return static_cast<int>(width);
}

std::string quantity_row(const Difference& difference, int width) {
  const ShownDifference row = shown(difference);
  return fmt::format("  {:<{}}{:>13}{:>13}{:>13}{:>12}{:>10}  {:<12}{}\n", row.label, width, row.base, row.other,
                     row.difference, row.bar, row.model, row.unit, row.verdict);
}

}  // namespace

ShownDifference shown(const Difference& row) {
  const double fine = std::isfinite(row.bar) ? row.bar : 1e-4 * std::max(std::abs(row.base), std::abs(row.other));
  const int digits = digits_for(fine);
  return {quantity_label(row.name),
          number(row.base, digits),
          number(row.other, digits),
          number(row.difference, digits, true),
          number(row.bar, digits),
          model_text(row.model),
          row.unit,
          name_of(row.significance())};
}

std::string models_line(const RunComparison& result, const FinishedRun& base, const FinishedRun& other) {
  const std::string text = models_text(base.quantities.models), of_other = models_text(other.quantities.models);
  if (text != of_other) {
    const auto named = [](const std::string& models) { return models.empty() ? "not told" : models; };
    return fmt::format("  the models differ: {} in the base, {} here; what that was found to move is under model\n",
                       named(text), named(of_other));
  }
  std::string smaller;
  for (const Difference& row : result.quantities)
    if (std::abs(row.difference) < row.model) smaller += (smaller.empty() ? "" : "; ") + quantity_label(row.name);
  if (models_move_text(base.quantities.models).empty()) return "";
  if (smaller.empty()) return fmt::format("  model of both: {}\n", text);
  return "  " +
         wrapped(fmt::format("model of both: {}; smaller than what the best one was found to move: {}", text, smaller),
                 4) +
         '\n';
}

std::string bars_line(const RunComparison& result, const FinishedRun& base, const FinishedRun& other) {
  const std::string& stopped = base.coarser_stopped.empty() ? other.coarser_stopped : base.coarser_stopped;
  if (result.bars == BarSource::none && !stopped.empty())
    return "  " + wrapped(fmt::format("no error bars: a coarser run stopped: {}; a finer accuracy helps", stopped), 4) +
           '\n';
  if (result.bars == BarSource::none)
    return "  no error bars: a run without coarser runs; `parison resume FOLDER --error-bars` makes them\n";
  const std::string scatter = result.scatter == ScatterSource::twins
                                  ? fmt::format("as {} twin run{} show{}", result.twins, result.twins == 1 ? "" : "s",
                                                result.twins == 1 ? "s" : "")
                                  : "as measured on other containers, since no twin run is there";
  const std::string means =
      result.pairs > 1 ? fmt::format("  each value is the mean of two runs, the second with {}\n", result.repeated)
                       : "";
  return means + fmt::format("  bars: {}; scatter {}\n",
                             result.bars == BarSource::differences
                                 ? "the difference against that of the coarser runs, so that common errors cancel"
                                 : "those of both runs added, since no coarser runs near enough are common to both",
                             scatter);
}

namespace {

/// Where the wall differs for sure, that is, by clearly more than its error, and where most clearly.
std::string wall_line(const ProfileComparison& walls) {
  constexpr double clearly = 1.25;
  const auto size = [&](std::size_t i) { return std::abs(walls.difference[i]); };
  std::size_t sure = 0, known = 0, most = 0;
  for (std::size_t i = 0; i < walls.bar.size(); ++i) {
    if (!std::isfinite(walls.bar[i])) continue;
    ++known;
    if (size(i) <= clearly * walls.bar[i]) continue;
    if (sure++ == 0 || size(i) - walls.bar[i] > size(most) - walls.bar[most]) most = i;
  }
  if (known == 0) return "";
  if (sure == 0) return "  wall: nowhere different by clearly more than its error\n";
  const int digits = digits_for(walls.bar[most]);
  return fmt::format(
      "  wall: different for sure at {:.0f} % of its places, most clearly at {:.3f} of the arc: {} mm, error {}\n",
      100 * double(sure) / double(known), double(most) / double(walls.bar.size() - 1),
      number(walls.difference[most], digits, true), number(walls.bar[most], digits));
}

std::string heading(const ComparedRun& other, const FinishedRun& base) {
  std::string text = fmt::format("\n{} against {}, {} accuracy: {}\n", other.label, base.name, base.accuracy,
                                 settings_line(other.settings));
  if (!other.result) return text + "  " + wrapped("no results: " + other.reason, 4) + '\n';
  if (other.run.accuracy != base.accuracy)
    text += fmt::format("  {} itself is of {} accuracy\n", other.label, other.run.accuracy);
  for (const FinishedRun* run : {&base, &other.run})
    if (!run->trustworthy)
      text += fmt::format("  {} is not trustworthy: checks of it are far beyond their limits, see {}/summary.json\n",
                          run->name, run->directory);
  for (const auto& [name, why] : {std::pair{base.name, base.not_possible}, {other.label, other.run.not_possible}})
    if (!why.empty()) text += "  " + wrapped(fmt::format("{} is no possible production: {}", name, why), 4) + '\n';
  if (other.result->in_common > 0)
    text += fmt::format("  the same run up to the end of stage {}\n", base.stages[other.result->in_common - 1].name);
  return text;
}

}  // namespace

const Difference* find_row(const ComparedRun& other, const std::string& quantity) {
  if (other.result)
    for (const Difference& row : other.result->quantities)
      if (row.name == quantity) return &row;
  return nullptr;
}

namespace {

/// Runs in result folders of the same name are told by the folder above too.
void tell_apart(Comparison& comparison) {
  std::set<std::string> names{comparison.base.name};
  bool alike = false;
  for (const ComparedRun& other : comparison.others) alike = !names.insert(other.label).second || alike;
  if (!alike) return;
  comparison.base.name = name_with_folder(comparison.base);
  for (ComparedRun& other : comparison.others) other.label = name_with_folder(other.run);
}

}  // namespace

Comparison compare_folders(const std::string& base, const std::vector<std::string>& others, Repeats repeats) {
  Comparison comparison{read_finished_run(base), {}};
  if (!comparison.base.completed) throw core::CaseError(no_base(base, comparison.base.reason));
  for (const std::string& folder : others) {
    FinishedRun run = read_finished_run(folder);
    ComparedRun other{run.name, settings_that_differ(comparison.base, run), run.reason, {}};
    if (run.completed)
      other.result = compare_runs(comparison.base, run, stages_without_influence(comparison.base, run), repeats);
    other.run = std::move(run);
    comparison.others.push_back(std::move(other));
  }
  tell_apart(comparison);
  return comparison;
}

std::string no_base(const std::string& folder, const std::string& reason) {
  return fmt::format(
      "{}: this run did not come to its end and cannot be the base; allowed is one that has completed. It stopped in "
      "{}",
      folder, reason);
}

void require_quantity(const std::string& quantity, const std::vector<Quantity>& known) {
  if (const std::string problem = unknown_quantity(quantity, known); !problem.empty())
    throw core::CaseError("--quantity: " + problem);
}

std::string comparison_tables(const Comparison& comparison) {
  std::string text;
  for (const ComparedRun& other : comparison.others) {
    text += heading(other, comparison.base);
    if (!other.result) continue;
    const int width = label_width(other.result->quantities);
    text += fmt::format("  {:<{}}{:>13}{:>13}{:>13}{:>12}{:>10}  {:<12}{}\n", "quantity", width, "base", "other",
                        "difference", "error bar", "model", "unit", "verdict");
    for (const Difference& row : other.result->quantities) text += quantity_row(row, width);
    text += wall_line(other.result->profile) + bars_line(*other.result, comparison.base, other.run) +
            models_line(*other.result, comparison.base, other.run);
  }
  return text + remark_lines(comparison);
}

std::string ranked_quantity(const Comparison& comparison) {
  const auto& values = comparison.base.quantities.values;
  return values.empty() || comparison.base.quantities.find(thinnest) ? thinnest : values.front().name;
}

std::string ranking_table(const Comparison& comparison, const std::string& quantity) {
  const Quantity* base = comparison.base.quantities.find(quantity);
  if (!base) return fmt::format("\n{} has no {} ({})\n", comparison.base.name, quantity_label(quantity), quantity);
  std::vector<const ComparedRun*> order;
  std::size_t width = 8;
  for (const ComparedRun& other : comparison.others) {
    order.push_back(&other);
    width = std::max(width, other.label.size());
  }
  const auto change = [&](const ComparedRun* run) {
    const Difference* row = find_row(*run, quantity);
    return row ? row->difference : -std::numeric_limits<double>::infinity();
  };
  std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return change(a) > change(b); });
  std::string text = fmt::format("\n{}: {:.5g} {} in {}; each change, the largest rise first:\n",
                                 quantity_label(quantity), base->value, base->unit, comparison.base.name);
  if (const std::string& why = comparison.base.not_possible; !why.empty())
    text += "  " +
            wrapped(fmt::format("no possible production in {}, what changes against it is of no use: {}",
                                comparison.base.name, why),
                    4) +
            '\n';
  for (const ComparedRun* run : order) {
    const Difference* row = find_row(*run, quantity);
    if (!row) {
      const std::string reason = run->reason.empty() ? "it does not have this quantity" : run->reason;
      text += fmt::format("  {:<{}}  {}\n", run->label, width, wrapped("no result: " + reason, width + 4));
      continue;
    }
    const int digits = digits_for(row->bar);
    text +=
        fmt::format("  {:<{}}  {:>10} {}{}: {}", run->label, width, number(row->difference, digits, true), row->unit,
                    std::isfinite(row->bar) ? " +- " + number(row->bar, digits) : "", name_of(row->significance()));
    if (row->significance() == Significance::real)
      text += fmt::format(", for sure {} by at least {} {}", row->difference > 0 ? "more" : "less",
                          number(std::abs(row->difference) - row->bar, digits), row->unit);
    text += '\n';
    if (!run->run.not_possible.empty())
      text += fmt::format("  {:<{}}  {}\n", "", width,
                          wrapped("no possible production: " + run->run.not_possible, width + 4));
  }
  return text;
}

}  // namespace parison::forming
