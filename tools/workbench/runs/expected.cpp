// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/runs/expected.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/io/json_read.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/scene.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {
namespace {

/// CPU time of a run at an accuracy over that at draft. Bundled cases took 2.8 to 4.8 times as long at each level more,
/// and 2.9 to 3.8 times as long as with edges and steps twice as long, which counts as a level.
double cost_over_draft(const std::string& accuracy) {
  constexpr double of_a_level = 4;
  return std::pow(of_a_level, forming::read_accuracy(accuracy).effective_level());
}

/// What a run has cost, as that of one at draft, s; from the least to the most of several.
struct Cost {
  std::string name;
  double over_draft;  ///< of its accuracy
  double least, most;
};

std::vector<Cost> costs_of(const std::vector<EndedRun>& known) {
  constexpr std::size_t most_read = 20;
  std::vector<Cost> costs;
  for (std::size_t i = 0; i < known.size() && i < most_read; ++i) {
    const auto summary = core::read_json_file(known[i].folder + "/summary.json");
    const double cpu = summary ? summary->number_of("cpu_seconds") : core::none;
    if (!summary || !summary->flag_of("completed") || !(cpu > 0)) continue;
    const double over = cost_over_draft(summary->text_of("accuracy"));
    costs.push_back({known[i].name, over, cpu / over, cpu / over});
  }
  return costs;
}

/// That of the bundled containers of round glass for the time in which the case forms; nothing for glass in space, and
/// where the case is refused.
std::optional<Cost> bundled_cost(const std::string& case_file) {
  double seconds = 0;
  try {
    const forming::Scene scene = forming::read_scene(case_file, "draft");
    if (scene.solid) return {};
    for (const forming::Stage& stage : scene.stages) seconds += stage.cools ? 0 : stage.duration;
  } catch (const core::CaseError&) {
    return {};
  }
  Cost cost{"", 1, HUGE_VAL, 0};
  for (const BundledCase& one : bundled_cases()) {
    const auto figures = core::read_json_file((shared_file("cases") / one.name / "figures.json").string());
    const auto* draft = figures ? figures->find("draft") : nullptr;
    const auto* stages = draft ? draft->find("stages") : nullptr;
    if (!stages || stages->items.size() < 2 || draft->find("solid")) continue;  // a test of one stage is no container
    const double of_a_second = draft->number_of("cpu_seconds") / draft->number_of("time_s");
    cost.least = std::min(cost.least, seconds * of_a_second);
    cost.most = std::max(cost.most, seconds * of_a_second);
  }
  if (cost.most == 0) return {};
  return cost;
}

}  // namespace

void add_expected(const std::string& case_file, const std::vector<std::string>& accuracies,
                  const std::vector<EndedRun>& known, core::JsonWriter& json) {
  std::vector<Cost> costs = costs_of(known);
  if (costs.empty())
    if (auto cost = bundled_cost(case_file)) costs.push_back(*std::move(cost));
  json.open_list("expected");
  for (const std::string& accuracy : accuracies) {
    const double over = cost_over_draft(accuracy);
    json.open_object("");
    json.add("accuracy", accuracy);
    json.add("error", forming::expected_error(forming::read_accuracy(accuracy).effective_level()));
    const auto nearer = [&](const Cost& a, const Cost& b) {
      return std::abs(std::log(over / a.over_draft)) < std::abs(std::log(over / b.over_draft));
    };
    if (const auto nearest = std::min_element(costs.begin(), costs.end(), nearer); nearest != costs.end()) {
      json.add("cpu_from_s", nearest->least * over);
      json.add("cpu_to_s", nearest->most * over);
      json.add("by", nearest->name);
    }
    json.close();
  }
  json.close();
}

}  // namespace parison::tools
