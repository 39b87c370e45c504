// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/what_if.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/case/case_error.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/case/text/case_text.hpp"
#include "core/case/units.hpp"
#include "forming/run/resume/case_change.hpp"
#include "forming/run/resume/checkpoint_files.hpp"
#include "forming/run/stage.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/finished_run.hpp"
#include "forming/study/comparison/same_case.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "forming/study/comparison/what_if/tool_overlap.hpp"

namespace parison::forming {
namespace {

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Reads a case and tries whether its first stage can begin.
Scene checked_scene(const WhatIf& what_if, const std::vector<std::string>& overrides) {
  Scene scene = read_scene(what_if.case_path, what_if.accuracy, overrides);
  if (const std::string reason = first_stage_failure(scene); !reason.empty())
    throw core::CaseError(
        fmt::format("{}: stage {} cannot begin: {}", what_if.case_path, scene.stages.front().name, reason));
  return scene;
}

/// Two assignments to one key, of which the last would count, were meant as two variants.
void require_keys_once(const WhatIf& what_if, const WhatIfVariant& variant) {
  const core::CaseFile file = read_case(what_if.case_path, joined(what_if.overrides, variant.overrides));
  if (const std::string repeated = core::repeated_key(file, variant.overrides); !repeated.empty())
    throw core::CaseError(
        fmt::format("{}; allowed is one of them, another --variant NAME goes before the second", repeated));
}

/// The same of a variant, whose tools must not overlap anew; what is refused carries its name.
Scene checked_variant(const WhatIf& what_if, const Scene& base, const WhatIfVariant& variant) {
  try {
    require_keys_once(what_if, variant);
    Scene scene = checked_scene(what_if, joined(what_if.overrides, variant.overrides));
    if (const auto other = other_case(base, scene))
      throw core::CaseError(
          fmt::format("{} {} was found, where the base has {}; allowed are changes of settings, with "
                      "the names, the geometry, the tools and the stages of the base",
                      other->what, other->other, other->base));
    if (const std::string overlap = new_tool_overlap(base, scene); !overlap.empty()) throw core::CaseError(overlap);
    return scene;
  } catch (const core::CaseError& error) {
    throw core::CaseError(fmt::format("{}: {}", variant_text(variant), error.what()));
  }
}

/// A variant that runs, and the last stage that it has in common with the base.
struct PlannedVariant {
  std::string name;
  Scene scene;
  std::optional<std::string> stage;
};

/// The variants that change something; one of them at least has to.
std::vector<PlannedVariant> checked_variants(const WhatIf& what_if, const Scene& base) {
  std::vector<PlannedVariant> variants;
  std::string nothing;
  for (const WhatIfVariant& variant : what_if.variants) {
    Scene scene = checked_variant(what_if, base, variant);
    if (const std::string unchanged = nothing_changed(what_if, variant); !unchanged.empty()) {
      nothing += (nothing.empty() ? "" : "; ") + unchanged;
      continue;
    }
    auto stage = last_common_stage(base, scene);
    variants.push_back({variant.name, std::move(scene), std::move(stage)});
  }
  if (variants.empty())
    throw core::CaseError(fmt::format("{}; allowed is at least one variant with a value of its own", nothing));
  return variants;
}

void require_names(const std::vector<WhatIfVariant>& variants) {
  if (variants.empty()) throw core::CaseError("what-if: no variant was found, allowed is at least one --set KEY=VALUE");
  std::set<std::string> names;
  for (const WhatIfVariant& variant : variants) {
    const bool is_plain = !variant.name.empty() && variant.name[0] != '.' &&
                          std::all_of(variant.name.begin(), variant.name.end(), [](unsigned char c) {
                            return std::isalnum(c) || c == '_' || c == '-' || c == '.' || c == '+';
                          });
    if (!is_plain)
      throw core::CaseError(fmt::format(
          "--variant: \"{}\" was found, allowed are letters, digits, '_', '-', '+' and '.' inside", variant.name));
    if (variant.name == base_name)
      throw core::CaseError(fmt::format(
          "--variant: \"{}\" was found, which is the name of the case without changes; allowed is another name",
          variant.name));
    if (!names.insert(variant.name).second)
      throw core::CaseError(
          fmt::format("--variant: \"{}\" was found twice, allowed are names of their own", variant.name));
    if (variant.overrides.empty())
      throw core::CaseError(
          fmt::format("variant {}: nothing that it changes was found, allowed is at least one --set KEY=VALUE after "
                      "--variant {}",
                      variant.name, variant.name));
  }
}

/// The assignments of a twin from the start: tools of a uniform temperature are warmer, or the glass where no tool has
/// one, as in settled production; empty where neither has.
std::vector<std::string> warmer_start(const Scene& scene) {
  std::vector<std::string> overrides;
  const auto is_uniform = [](const Body& body) { return body.thermal && !body.start_field; };
  const auto warm = [&](const std::string& key, const Body& body) {
    overrides.push_back(fmt::format("{}.temperature={:.9g} K", key, body.initial_temperature + twin_warmer));
  };
  for (const Tool& tool : scene.tools)
    if (is_uniform(tool)) warm("tool." + tool.name, tool);
  if (overrides.empty() && is_uniform(scene.glass) && !scene.glass.skin) warm("glass", scene.glass);
  return overrides;
}

/// The folder in which a run of the base, its coarser ones or their twins has ended elsewhere; empty for none.
std::string finished_elsewhere(const WhatIf& what_if, const std::string& directory) {
  const std::string base = what_if.directory + '/' + base_name;
  if (what_if.base_results.empty() || directory.rfind(base, 0) != 0) return {};
  const std::string known = what_if.base_results + directory.substr(base.size());
  return has_completed_here(known) ? known : std::string();
}

/// The coarser runs of a run; where all is done twice, only the one nearest to it, since no other would count.
std::vector<CoarseCase> partner_cases(const WhatIf& what_if, const Scene& scene, const std::string& directory) {
  std::vector<CoarseCase> cases;
  for (std::size_t i = 0; i < (what_if.twice ? 1 : partner_folders.size()); ++i)
    if (auto coarse = coarse_case(scene, directory + '/' + partner_folders[i], partner_run_factors(scene)[i]))
      cases.push_back(std::move(*coarse));
  return cases;
}

/// A coarser run of the run in the folder `own`.
PlannedRun partner_of(const std::string& label, const CoarseCase& coarse, const std::optional<BranchPoint>& branch,
                      const std::string& own) {
  return {fmt::format("{}, {:g} times coarser", label, coarse.factor),
          coarse.directory,
          coarse.accuracy,
          coarse.overrides,
          branch,
          own};
}

/// A run and its coarser ones; `stage` where they begin as those of the base had it at its end.
void add_runs(const WhatIf& what_if, const std::string& label, const Scene& scene,
              const std::optional<std::string>& stage, std::vector<PlannedRun>& runs) {
  const std::string base = what_if.directory + '/' + base_name, own = what_if.directory + '/' + label;
  const auto branch = [&](const std::string& folder) {
    return stage ? std::optional(BranchPoint{base + folder, *stage}) : std::nullopt;
  };
  const bool is_base = label == base_name;
  const auto elsewhere = [&](const std::string& folder) {
    return is_base ? finished_elsewhere(what_if, folder) : std::string();
  };
  runs.push_back({label, own, scene.accuracy_name, scene.overrides, branch(""), "", elsewhere(own)});
  for (const CoarseCase& coarse : partner_cases(what_if, scene, own)) {
    runs.push_back(partner_of(label, coarse, branch(coarse.directory.substr(own.size())), own));
    runs.back().copy_of = elsewhere(coarse.directory);
  }
}

/// A twin of a run that was made of a scene; `base` is the folder of the same run of the base, from which it begins at
/// the end of a stage.
PlannedRun twin_of(const WhatIf& what_if, const std::string& label, const CoarseCase& run, const std::string& base,
                   const std::optional<std::string>& stage, const std::vector<std::string>& warmer) {
  const std::string coarser = run.factor > 1 ? fmt::format(", {:g} times coarser", run.factor) : "";
  PlannedRun twin{fmt::format("twin of {}{}{}", label, coarser, stage ? ", after " + *stage : ""),
                  run.directory + '/' + (stage ? twin_after + *stage : twin_folder),
                  run.accuracy,
                  stage ? run.overrides : joined(run.overrides, warmer),
                  stage ? std::optional(BranchPoint{base, *stage, true}) : std::nullopt,
                  run.directory};
  twin.copy_of = finished_elsewhere(what_if, twin.directory);
  return twin;
}

/// A run itself and its coarser ones.
std::vector<CoarseCase> all_cases(const WhatIf& what_if, const Scene& scene, const std::string& directory) {
  std::vector<CoarseCase> cases{{scene.file, scene.accuracy_name, directory, scene.overrides, 1}};
  for (CoarseCase& coarse : partner_cases(what_if, scene, directory)) cases.push_back(std::move(coarse));
  return cases;
}

/// A twin of each coarser run of the base, and of the base itself where all is done twice, from each point at which
/// variants leave it.
void add_base_twins(const WhatIf& what_if, const Scene& scene, const std::set<std::optional<std::string>>& stages,
                    std::vector<PlannedRun>& runs) {
  const std::vector<std::string> warmer = warmer_start(scene);
  if (warmer.empty()) return;
  for (const CoarseCase& one : all_cases(what_if, scene, what_if.directory + '/' + base_name))
    for (const auto& stage : stages)
      if (one.factor > 1 || what_if.twice)
        runs.push_back(twin_of(what_if, base_name, one, one.directory, stage, warmer));
}

/// A twin of a variant and of its coarser run.
void add_variant_twins(const WhatIf& what_if, const std::string& label, const Scene& scene,
                       const std::optional<std::string>& stage, std::vector<PlannedRun>& runs) {
  const std::vector<std::string> warmer = warmer_start(scene);
  if (warmer.empty()) return;
  const std::string base = what_if.directory + '/' + base_name, own = what_if.directory + '/' + label;
  for (const CoarseCase& one : all_cases(what_if, scene, own))
    runs.push_back(twin_of(what_if, label, one, base + one.directory.substr(own.size()), stage, warmer));
}

/// A quantity as it is written, in SI, and its dimension; nothing where the text is none.
std::optional<std::pair<double, core::Dimension>> measured(const std::string& text) {
  const auto read = core::leading_number(text);
  if (!read) return std::nullopt;
  const auto unit = read->rest.empty() ? core::Unit{} : core::parse_unit(read->rest);
  if (read->rest == "degC") return std::pair(read->value + core::zero_celsius, core::dimension::temperature);
  return unit ? std::optional(std::pair(read->value * unit->factor, unit->dimension)) : std::nullopt;
}

/// Whether a value is the same, written otherwise.
bool is_same_value(const CaseDifference& setting) {
  const auto before = measured(setting.before), now = measured(setting.now);
  return before && now && core::same_exponents(before->second, now->second) &&
         std::abs(before->first - now->first) <= 1e-12 * std::abs(before->first);
}

}  // namespace

WhatIfVariant variant_of(const std::string& assignment) {
  constexpr std::size_t longest = 60;
  std::string name;
  for (const char c : assignment.substr(0, longest)) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '-' || c == '+';
    if (plain || (!name.empty() && name.back() != '_')) name += plain ? c : '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return {name, {assignment}};
}

std::optional<std::string> last_common_stage(const Scene& base, const Scene& changed) {
  for (Index stage = static_cast<Index>(base.stages.size()) - 2; stage >= 0; --stage)
    if (used_change(base.file, base.overrides, changed, stage).empty())
      return base.stages[static_cast<std::size_t>(stage)].name;
  return std::nullopt;
}

std::vector<PlannedRun> plan_runs(const WhatIf& what_if) {
  require_names(what_if.variants);
  const Scene base = checked_scene(what_if, what_if.overrides);
  std::vector<PlannedRun> runs;
  add_runs(what_if, base_name, base, std::nullopt, runs);
  const std::vector<PlannedVariant> variants = checked_variants(what_if, base);
  std::set<std::optional<std::string>> stages;
  for (const PlannedVariant& variant : variants) {
    if (variant.stage && !what_if.base_results.empty())
      find_stage_end(what_if.base_results, *variant.stage);  // refuses where it is gone
    stages.insert(variant.stage);
  }
  add_base_twins(what_if, base, stages, runs);
  for (const PlannedVariant& variant : variants) {
    add_runs(what_if, variant.name, variant.scene, variant.stage, runs);
    if (what_if.twice) add_variant_twins(what_if, variant.name, variant.scene, variant.stage, runs);
  }
  return runs;
}

std::vector<PlannedRun> plan_partner_runs(const std::string& case_path, const std::vector<std::string>& folders) {
  std::vector<PlannedRun> runs;
  for (const std::string& folder : folders) {
    const FinishedRun run = read_finished_run(folder);
    const std::string label = name_with_folder(run);
    const Scene scene = read_scene(case_path, run.accuracy, run.overrides);
    const std::vector<std::string> warmer = warmer_start(scene);
    for (const CoarseCase& coarse : partner_cases({}, scene, folder)) {
      runs.push_back(partner_of(label, coarse, std::nullopt, folder));
      if (folder == folders.front() && !warmer.empty())
        runs.push_back(twin_of({}, label, coarse, coarse.directory, std::nullopt, warmer));
    }
  }
  return runs;
}

std::vector<CaseDifference> settings_of(const WhatIf& what_if, const WhatIfVariant& variant) {
  return case_differences(what_if.case_path, what_if.overrides, what_if.case_path,
                          joined(what_if.overrides, variant.overrides));
}

std::vector<CaseDifference> changed_settings(const WhatIf& what_if, const WhatIfVariant& variant) {
  auto settings = settings_of(what_if, variant);
  settings.erase(std::remove_if(settings.begin(), settings.end(), is_same_value), settings.end());
  return settings;
}

std::string variant_text(const WhatIfVariant& variant) {
  return fmt::format("variant {} ({})", variant.name, fmt::join(variant.overrides, ", "));
}

std::vector<std::string> settled_replaced(const WhatIf& what_if, const WhatIfVariant& variant) {
  const Scene base = read_scene(what_if.case_path, what_if.accuracy, what_if.overrides);
  const Scene scene = read_scene(what_if.case_path, what_if.accuracy, joined(what_if.overrides, variant.overrides));
  std::vector<std::string> notes;
  for (std::size_t t = 0; t < base.tools.size() && t < scene.tools.size(); ++t)
    if (base.tools[t].start_field && !scene.tools[t].start_field)
      notes.push_back(fmt::format(
          "variant {}: the tool \"{}\" starts at {:.0f} degC all over, where the base has the temperatures that an "
          "earlier run or production has left in it; `parison cycle` with a change of cooling finds what it settles to",
          variant.name, scene.tools[t].name, scene.tools[t].initial_temperature - core::zero_celsius));
  return notes;
}

std::string nothing_changed(const WhatIf& what_if, const WhatIfVariant& variant) {
  if (!changed_settings(what_if, variant).empty()) return {};
  return fmt::format("variant {} changes nothing: the base has {} already", variant.name,
                     fmt::join(variant.overrides, ", "));
}

}  // namespace parison::forming
