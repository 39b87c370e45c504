// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/io/written_files.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "forming/study/production/cycle_run.hpp"
#include "tools/commands/study/cycle.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

/// The case or a variant of it, and what became of its production.
struct Production {
  std::string name, folder;
  forming::Scene scene;
  forming::MachineCycle machine;
  std::vector<forming::CaseDifference> settings = {};  ///< in which it differs from the base
  std::string failure = {};                            ///< why it did not settle, empty where it did
  double uncertainty = 0;                              ///< of the tool surfaces, K

  std::string container() const { return folder + "/settled"; }
};

Production production_of(const CycleRequest& request, const CyclePlan& plan, const forming::WhatIfVariant& variant) {
  std::vector<std::string> overrides = request.overrides;
  overrides.insert(overrides.end(), variant.overrides.begin(), variant.overrides.end());
  forming::Scene scene = forming::read_scene(request.case_path, request.accuracy, overrides);
  try {
    forming::MachineCycle machine = forming::machine_cycle(scene, plan.seconds, plan.sets);
    forming::check_wanted(scene, machine, plan.wanted);
    return {variant.name, request.output + '/' + variant.name, std::move(scene), std::move(machine)};
  } catch (const core::CaseError& error) {
    throw core::CaseError(fmt::format("{}: {}", variant.name, error.what()));
  }
}

/// Refuses a variant all of whose changes settled production loses; tells those of another one.
void check_lost_changes(const forming::WhatIf& asked, const forming::WhatIfVariant& variant,
                        const forming::Scene& scene) {
  const auto settings = forming::changed_settings(asked, variant);
  const std::vector<std::string> lost = forming::lost_changes(scene, settings);
  if (lost.empty()) return;
  const std::string found =
      fmt::format("{}: {} was found, but production settles to the same tool temperatures from wherever it starts",
                  forming::variant_text(variant), fmt::join(lost, ", "));
  const std::string allowed = forming::what_settled_tools_depend_on(lost.front());
  if (lost.size() == settings.size()) throw core::CaseError(fmt::format("{}; allowed are {}", found, allowed));
  fmt::print("{}: what is compared is the effect of its other changes; a change of tool temperatures takes {}\n", found,
             allowed);
}

/// The base first. A variant that changes nothing is told and left out.
std::vector<Production> read_all(const CycleRequest& request, const CyclePlan& plan) {
  const forming::WhatIf asked{request.case_path, request.accuracy, request.output, request.overrides, request.variants};
  forming::plan_runs(asked);  // what `what-if` refuses is refused here too
  std::vector<Production> all{production_of(request, plan, {forming::base_name, {}})};
  for (const forming::WhatIfVariant& variant : request.variants) {
    check_lost_changes(asked, variant, all.front().scene);
    if (const std::string nothing = forming::nothing_changed(asked, variant); !nothing.empty()) {
      fmt::print("{}; it is not run\n", nothing);
      continue;
    }
    all.push_back(production_of(request, plan, variant));
    all.back().settings = forming::settings_of(asked, variant);
  }
  return all;
}

/// A tool of another shape than that of the base takes no temperatures from it: the search then starts from the case.
forming::PeriodicState find_settled_from(const Production& one, forming::PeriodicRequest& asked) {
  if (!asked.changed_from.empty()) try {
      return find_settled(one.scene, one.machine, asked);
    } catch (const core::CaseError&) {
      asked.changed_from.clear();
    }
  return find_settled(one.scene, one.machine, asked);
}

/// What later comparisons of the folder need of a variant that cannot be followed.
void write_failure(const Production& one, const forming::PeriodicRequest& asked) {
  std::error_code error;
  std::filesystem::create_directories(one.folder, error);
  if (!std::filesystem::is_directory(one.folder, error)) return;
  forming::PeriodicState nothing;
  nothing.cycle = one.machine;
  forming::write_periodic_state(one.scene, asked, nothing, one.failure);
}

/// What was found of the production; nothing where a variant cannot be followed, which is its failure alone.
std::optional<forming::PeriodicState> try_to_settle(Production& one, forming::PeriodicRequest& asked, bool is_base) {
  try {
    return find_settled_from(one, asked);
  } catch (const std::exception& error) {
    if (is_base) throw;
    one.failure = error.what();
    fmt::print(stderr, "parison: {}: {}\n", one.name, one.failure);
    write_failure(one, asked);
    return std::nullopt;
  }
}

/// `base`: folder of the production that this one is a change of; empty for the base itself. False where it was stopped
/// on request.
bool settle(const CycleRequest& request, const CyclePlan& plan, const std::string& base, Production& one) {
  forming::PeriodicRequest asked;
  if (!base.empty()) asked.changed_from = base + "/tools";
  asked.tolerance = plan.tolerance;
  asked.max_runs = request.max_runs;
  asked.directory = one.folder;
  asked.changes = one.settings;
  asked.wanted = plan.wanted;
  fmt::print("\n{} at {} accuracy: a machine cycle of {:.4g} s\n", one.name, one.scene.accuracy_name,
             one.machine.seconds);
  std::fflush(stdout);
  const std::optional<forming::PeriodicState> found = try_to_settle(one, asked, base.empty());
  if (!found) return true;
  const forming::PeriodicState& state = *found;
  one.uncertainty = std::max(state.uncertainty, state.offset);
  one.failure = !state.failure.empty() ? state.failure : not_confirmed(state, asked);
  if (state.failure.empty())
    fmt::print("{}\n{}{}", forming::periodic_table(one.scene, state), search_lines(state, asked), cooling_lines(state));
  if (!one.failure.empty()) fmt::print(stderr, "parison: {}: {}\n", one.name, one.failure);
  return !state.stopped;
}

/// The containers of the variants beside that of the base, each on the tools to which its own production settles.
forming::Comparison compare_settled(const std::vector<Production>& all) {
  std::vector<std::string> others;
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].failure.empty()) others.push_back(all[i].container());
  forming::Comparison comparison = forming::compare_folders(all.front().container(), others);
  for (const Production& one : all)
    if (!one.failure.empty()) comparison.others.push_back({one.name, one.settings, one.failure, {}});
  return comparison;
}

}  // namespace

int cycle_variants(const CycleRequest& request, const CyclePlan& plan) {
  std::vector<Production> all = read_all(request, plan);
  core::claim_folder(request.output, "cycle", {});
  for (const Production& one : all) print_notes_on_cycle(one.scene, one.machine, one.name + ": ");
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!settle(request, plan, i > 0 ? all.front().folder : "", all[i]) || !all.front().failure.empty())
      return run_failed;
  std::vector<std::string> containers;
  double uncertainty = 0;
  for (const Production& one : all)
    if (one.failure.empty()) {
      containers.push_back(one.container());
      uncertainty = std::max(uncertainty, one.uncertainty);
    }
  if (!make_coarser_runs(all.front().scene.file, containers, request.jobs)) {
    fmt::print(stderr, "parison: stopped on request before the coarser runs of the error bars had ended\n");
    return run_failed;
  }
  const forming::Comparison comparison = compare_settled(all);
  fmt::print("{}{}", forming::comparison_tables(comparison),
             forming::ranking_table(comparison, forming::ranked_quantity(comparison)));
  fmt::print(
      "  each on the tools to which its own production settles; their surfaces are known to {:.2g} K, and what that\n"
      "  leaves open in the containers is not in the error bars\n",
      uncertainty);
  fmt::print("\n  {}\n", forming::write_comparison(comparison, request.output));
  return containers.size() == all.size() ? 0 : run_failed;
}

}  // namespace parison::tools
