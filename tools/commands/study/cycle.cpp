// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/study/cycle.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/case/units.hpp"
#include "core/io/written_files.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/production/cycle_files.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::PeriodicState;

/// A positive quantity of the command line.
double positive(const std::string& option, const std::string& text, const core::Dimension& dimension,
                const char* example) {
  const auto parsed = core::parse_quantity(text, dimension);
  if (!parsed.problem.empty()) throw core::CaseError(fmt::format("{}: {}", option, parsed.problem));
  if (parsed.value <= 0)
    throw core::CaseError(
        fmt::format("{}: \"{}\" was found, allowed are values above zero such as \"{}\"", option, text, example));
  return parsed.value;
}

/// Sets that take turns, by tool.
std::map<std::string, int> sets_of(const CycleRequest& request) {
  std::map<std::string, int> sets;
  for (const std::string& text : request.sets) {
    const auto equals = text.find('=');
    char* end = nullptr;
    const long count = equals == text.npos ? 0 : std::strtol(text.c_str() + equals + 1, &end, 10);
    if (count < 1 || count > 100 || *end != '\0')
      throw core::CaseError(fmt::format(
          "--sets: \"{}\" was found, allowed is a tool and how many sets of it take turns, \"ring=2\"", text));
    sets[text.substr(0, equals)] = static_cast<int>(count);
  }
  return sets;
}

/// Temperatures that tools are to settle to.
std::vector<forming::WantedTool> wanted_of(const CycleRequest& request) {
  std::vector<forming::WantedTool> wanted;
  for (const std::string& text : request.wanted) {
    const auto equals = text.find('=');
    if (equals == text.npos || equals == 0)
      throw core::CaseError(fmt::format(
          "--want: \"{}\" was found, allowed is a tool and the temperature of its surface, \"blank=450 degC\"", text));
    const std::string name = text.substr(0, equals);
    wanted.push_back(
        {name, positive("--want " + name, text.substr(equals + 1), core::dimension::temperature, "450 degC")});
  }
  return wanted;
}

std::string new_folder(const CycleRequest& request, const std::string& name) {
  const std::string folder = request.output.empty() ? "results/cycle_" + name : request.output;
  std::error_code error;
  if (fs::exists(folder, error) && (!fs::is_directory(folder, error) || !fs::is_empty(folder, error)))
    throw core::CaseError(fmt::format("{}: it exists and is not empty, allowed is a new folder", folder));
  return folder;
}

/// The container of the first gob beside that of settled production, and that made just after a swab; false where error
/// bars were asked for and their runs were stopped.
bool compare_containers(const CycleRequest& request, const forming::Scene& scene, const std::string& folder,
                        const PeriodicState& state) {
  std::vector<std::string> others{folder + "/settled"};
  if (state.just_swabbed) others.push_back(folder + "/just_swabbed");
  std::vector<std::string> containers{folder + "/first_gob"};
  containers.insert(containers.end(), others.begin(), others.end());
  const bool ended = !request.error_bars || make_coarser_runs(scene.file, containers, request.jobs);
  const auto comparison = forming::compare_folders(containers.front(), others);
  fmt::print("{}", forming::comparison_tables(comparison));
  if (request.error_bars)
    fmt::print("{}", forming::ranking_table(comparison, forming::ranked_quantity(comparison)));
  else
    fmt::print("  `parison cycle --error-bars` tells which differences are real\n");
  forming::write_comparison(comparison, folder);
  return ended;
}

/// The options by which `parison run` of the case begins with the tools of a folder, as they are pasted into a shell.
std::string start_from_tools(const forming::Scene& scene, const PeriodicState& state, const std::string& folder) {
  std::vector<std::string> options;
  for (const forming::Cooling& one : state.cooling)
    options.push_back(fmt::format("--set '{}={:.10g} W/m2/K'", one.key(), one.h));
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const std::string& name = scene.tools[t].name;
    options.push_back(fmt::format("--set 'tool.{}.temperature={{ from = \"{}\" }}'", name, folder));
    if (state.cycle.overlaps(t))  // it still serves the container before at the gob
      options.push_back(fmt::format("--set 'tool.{}.temperature_at=first use'", name));
  }
  return fmt::format("{}", fmt::join(options, " \\\n    "));
}

/// False where a run of the error bars was stopped.
bool print_result(const CycleRequest& request, const forming::Scene& scene, const forming::PeriodicRequest& asked,
                  const PeriodicState& state) {
  fmt::print("{}", forming::periodic_table(scene, state));
  fmt::print("\n{}{}", search_lines(state, asked), cooling_lines(state));
  const bool ended = compare_containers(request, scene, asked.directory, state);
  fmt::print("\n  results in {}; a run starts from these tools with\n    {}\n", asked.directory,
             start_from_tools(scene, state, fs::absolute(asked.directory + "/tools").lexically_normal().string()));
  return ended;
}

}  // namespace

int cycle(const CycleRequest& request) {
  catch_signals();
  if (forming::read_accuracy(request.accuracy).target)
    throw core::CaseError(fmt::format(
        "--accuracy: {} was found, allowed are draft, standard, fine, coarser or finer ones", request.accuracy));
  CyclePlan plan{{},
                 positive("--tolerance", request.tolerance, core::dimension::temperature_difference, "0.5 K"),
                 sets_of(request),
                 wanted_of(request)};
  if (!request.cycle_time.empty())
    plan.seconds = positive("--cycle-time", request.cycle_time, core::dimension::time, "12 s");
  const forming::Scene scene = forming::read_scene(request.case_path, request.accuracy, request.overrides);
  if (scene.solid)
    throw core::CaseError(fmt::format(
        "{}: the glass is a body in space from stage \"{}\" on, allowed for `parison cycle` are cases whose "
        "glass stays round",
        scene.file, scene.stages[scene.solid->from_stage].name));
  const std::string folder = new_folder(request, scene.name);
  if (!request.variants.empty()) {
    CycleRequest with_folder = request;
    with_folder.output = folder;
    return cycle_variants(with_folder, plan);
  }
  const forming::PeriodicRequest asked{plan.tolerance, request.max_runs, folder, {}, {}, plan.wanted};
  const forming::MachineCycle machine = forming::machine_cycle(scene, plan.seconds, plan.sets);
  forming::check_wanted(scene, machine, plan.wanted);
  core::claim_folder(folder, "cycle", {});
  print_notes_on_cycle(scene, machine, "");
  fmt::print("{} at {} accuracy: a machine cycle of {:.4g} s\n", scene.name, scene.accuracy_name, machine.seconds);
  std::fflush(stdout);
  const PeriodicState state = find_settled(scene, machine, asked);
  if (!state.failure.empty()) {
    fmt::print(stderr, "parison: {}\n", state.failure);
    return run_failed;
  }
  if (!print_result(request, scene, asked, state)) {
    fmt::print(stderr, "parison: stopped on request before the coarser runs of the error bars had ended\n");
    return run_failed;
  }
  const std::string doubt = not_confirmed(state, asked);
  if (doubt.empty()) return 0;
  fmt::print(stderr, "parison: {}\n", doubt);
  return run_failed;
}

}  // namespace parison::tools
