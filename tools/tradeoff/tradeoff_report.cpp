// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/written_files.hpp"
#include "forming/study/convergence_study.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/program/child_process.hpp"
#include "tools/tradeoff/tradeoff.hpp"

namespace parison::tools {

namespace {

std::string path_of(const std::string& folder) {
  return folder + ".timings";
}

}  // namespace

std::vector<double> read_timings(const std::string& folder) {
  std::vector<double> seconds;
  if (!std::filesystem::exists(path_of(folder))) return seconds;
  std::istringstream lines(core::read_text(path_of(folder)));
  for (double value; lines >> value;) seconds.push_back(value);
  if (!lines.eof())
    throw core::CaseError(
        fmt::format("{}: a line without a number was found, allowed are CPU seconds", path_of(folder)));
  return seconds;
}

void add_timing(const std::string& folder, double cpu) {
  std::string text;
  for (const double seconds : read_timings(folder)) text += fmt::format("{:.6g}\n", seconds);
  core::replace_file(path_of(folder), text + fmt::format("{:.6g}\n", cpu));
}

void forget_timings(const std::string& folder) {
  core::remove_own(path_of(folder));
}

namespace {

using forming::VariantResult;
using Results = std::vector<VariantResult>;

VariantResult read_result(const std::string& folder, const forming::Variant& variant) {
  VariantResult result;
  result.variant = variant;
  const auto found = core::read_json_file(folder + '/' + variant.name + "/summary.json");
  if (!found) {
    result.reason = "no summary";
    return result;
  }
  const core::JsonValue& summary = *found;
  result.completed = summary.flag_of("completed");
  result.reason = summary.text_of("reason");
  result.cpu = summary.number_of("cpu_seconds");
  for (const double seconds : read_timings(folder + '/' + variant.name)) result.cpu = std::min(result.cpu, seconds);
  result.steps = static_cast<long>(summary.number_of("steps"));
  result.reynolds = summary.number_of("max_reynolds");
  if (result.completed) result.quantities = forming::read_quantities(summary);
  return result;
}

bool is_preset(const VariantResult& result) {
  return result.variant.accuracy.find(' ') == std::string::npos && result.variant.group == "accuracy";
}

std::string percent(double value) {
  return std::isfinite(value) ? fmt::format("{:.3g}", 100 * value) : "";
}

const VariantResult& compared_with(const Results& results, const VariantResult& result, const VariantResult& base) {
  return result.variant.group == "model" ? base : results.front();
}

std::string as_csv(const Results& results, const VariantResult& base) {
  std::string text =
      "variant,group,accuracy,overrides,completed,cpu_s,steps,thickness_mean_%,thickness_max_%,at_arc_fraction,heat_%,"
      "on_"
      "front";
  for (const auto& quantity : results.front().quantities.values)
    text += fmt::format(",{0}_{1},{0}_change", quantity.name, quantity.unit);
  text += '\n';
  for (const VariantResult& r : results) {
    text += fmt::format("{},{},{},{},{},{:.4g},{},{},{},{:.4g},{},{}", r.variant.name, r.variant.group,
                        core::csv_text(r.variant.accuracy),
                        core::csv_text(fmt::format("{}", fmt::join(r.variant.overrides, "; "))), r.completed ? 1 : 0,
                        r.cpu, r.steps, percent(r.profile.mean), percent(r.profile.max), r.profile.where,
                        percent(r.heat), r.on_front ? 1 : 0);
    for (const auto& quantity : results.front().quantities.values) {
      const auto *own = r.quantities.find(quantity.name),
                 *other = compared_with(results, r, base).quantities.find(quantity.name);
      text += own && other ? fmt::format(",{:.8g},{:.4g}", own->value, own->value - other->value) : ",,";
    }
    text += '\n';
  }
  return text;
}

std::string as_json(const Results& results, const VariantResult& base,
                    const std::vector<forming::PartSensitivity>& estimates) {
  core::JsonWriter json;
  json.add("base", base.variant.name);
  json.open_list("estimates");
  for (const forming::PartSensitivity& part : estimates) {
    json.open_object("");
    json.add("part", part.name);
    json.add("in_scene", part.in_scene);
    json.add("number", part.number);
    json.add("thickness", part.thickness);
    json.add("heat", part.heat);
    json.close();
  }
  json.close();
  json.open_list("variants");
  for (const VariantResult& r : results) {
    json.open_object("");
    json.add("name", r.variant.name);
    json.add("group", r.variant.group);
    json.add("accuracy", r.variant.accuracy);
    json.add("what", r.variant.what);
    json.add("completed", r.completed);
    json.add("reason", r.reason);
    json.add("preset", is_preset(r));
    json.add("on_front", r.on_front);
    json.add("cpu_seconds", r.cpu);
    json.add("cpu_over_best_line", is_preset(r) ? forming::over_front(results, r) : std::nan(""));
    json.add("error", r.error());
    json.add("thickness_mean", r.profile.mean);
    json.add("thickness_max", r.profile.max);
    json.add("thickness_max_at", r.profile.where);
    json.add("heat", r.heat);
    json.open_object("changes");
    for (const auto& quantity : r.quantities.values)
      if (const auto* other = compared_with(results, r, base).quantities.find(quantity.name))
        json.add(quantity.name, quantity.value - other->value);
    json.close();
    json.close();
  }
  return json.finish();
}

std::string numerics_table(const Results& results) {
  std::string text =
      "| settings | CPU, s | thickness, mean % | largest % | heat into tools % | |\n|---|---|---|---|---|---|\n";
  for (const VariantResult& r : results)
    if (r.variant.group != "model")
      text += r.completed
                  ? fmt::format("| {} | {:.4g} | {} | {} | {} | {} |\n", r.variant.name, r.cpu, percent(r.profile.mean),
                                percent(r.profile.max), percent(r.heat), r.on_front ? "on the best line" : "")
                  : fmt::format("| {} | | | | | {} |\n", r.variant.name, r.reason);
  for (const VariantResult& r : results)
    if (is_preset(r) && r.completed)
      if (const double over = forming::over_front(results, r); std::isfinite(over))
        text += fmt::format("\n{}: {:.2f} times the CPU time of the best line at its error.", r.variant.name, over);
  return text + '\n';
}

std::string changes(const VariantResult& r, const VariantResult& base) {
  std::string text;
  for (const auto& quantity : r.quantities.values)
    if (const auto* other = base.quantities.find(quantity.name))
      text += fmt::format("{}{} {:+.3g} {}", text.empty() ? "" : ", ", quantity.name, quantity.value - other->value,
                          quantity.unit);
  return text;
}

/// What each part of the model changes against the base, and what of its time it takes.
std::string model_table(const Results& results, const VariantResult& base,
                        const std::vector<forming::PartSensitivity>& estimates) {
  std::string rows;
  for (const VariantResult& r : results)
    if (r.variant.group == "model")
      rows += r.completed ? fmt::format("| {} | {} | {} | {} | {:+.0f} | {} |\n", r.variant.what,
                                        percent(r.profile.mean), percent(r.profile.max), percent(r.heat),
                                        100 * (base.cpu - r.cpu) / base.cpu, changes(r, base))
                          : fmt::format("| {} | | | | | {} |\n", r.variant.what, r.reason);
  for (const forming::PartSensitivity& part : estimates)
    if (!part.in_the_model)
      rows += fmt::format(
          "| {} (never in the model; estimated by {} {:.2g}, largest Reynolds number {:.2g}) | {:.2g} | | | | |\n",
          part.name, part.number_name, part.number, base.reynolds, 100 * part.thickness);
  if (rows.empty()) return {};
  return fmt::format(
             "\nWithout a part, or with one that the case leaves out, against {}:\n\n| part | thickness, mean % | "
             "largest % | heat into tools % | its share of the CPU time, % | changes |\n"
             "|---|---|---|---|---|---|\n",
             base.variant.name) +
         rows;
}

/// Whether the accuracy level has no effect: where a case maps its mesh and sets its steps the presets compute the
/// same.
bool presets_agree(const Results& results) {
  const VariantResult* first = nullptr;
  int alike = 0;
  for (const VariantResult& r : results) {
    if (!is_preset(r) || !r.completed) continue;
    if (first && r.error() != first->error()) return false;
    first = &r;
    ++alike;
  }
  return alike > 1 && first->error() > 0;
}

std::string error_laws(const Results& results) {
  if (presets_agree(results)) return "\nThe presets compute the same: the case sets its mesh and its steps itself.\n";
  std::string text;
  const std::pair<const char*, double (*)(const VariantResult&)> laws[] = {
      {"thickness", [](const VariantResult& r) { return r.profile.mean; }},
      {"heat", [](const VariantResult& r) { return r.heat; }}};
  for (const auto& [name, error] : laws)
    if (const auto law = forming::fit_error_law(results, error); std::isfinite(law.at_draft))
      text += fmt::format("\nerror of the {}: {:.2g} % * 2^(-{:.2f} level), level 0 draft, 1 standard, 2 fine", name,
                          100 * law.at_draft, law.order);
  return text.empty() ? text : text + '\n';
}

/// By the script that comes with the program.
void plot(const std::string& folder) {
  const std::filesystem::path script = shared_file("tools/plot_tradeoff.py");
  const std::string place = std::filesystem::absolute(folder).string();  // never taken for an option
  if (script.empty() || !run_program({"/usr/bin/python3", "-B", script.string(), place}))
    fmt::print("No plot was made: it needs python3-matplotlib; then tools/plot_tradeoff.py {} makes it.\n", folder);
}

}  // namespace

bool report_tradeoff(const std::string& folder, const std::vector<forming::Variant>& variants,
                     const std::string& base_name, const std::vector<forming::PartSensitivity>& estimates) {
  Results results;
  results.reserve(variants.size());
  for (const forming::Variant& variant : variants) results.push_back(read_result(folder, variant));
  const VariantResult& base = *std::find_if(results.begin(), results.end(),
                                            [&](const VariantResult& r) { return r.variant.name == base_name; });
  if (!results.front().completed || !base.completed) {
    const VariantResult& missing = results.front().completed ? base : results.front();
    fmt::print(stderr, "parison: no comparison without {}: {}\n", missing.variant.name, missing.reason);
    return false;
  }
  forming::compare_variants(results, base_name);
  forming::mark_front(results);
  const std::string table = numerics_table(results) + model_table(results, base, estimates) + error_laws(results);
  core::replace_file(folder + "/tradeoff.csv", as_csv(results, base));
  core::replace_file(folder + "/tradeoff.json", as_json(results, base, estimates));
  core::replace_file(folder + "/tradeoff.md", table);
  fmt::print("\n{}\n", table);
  std::fflush(stdout);
  plot(folder);
  return true;
}

}  // namespace parison::tools
