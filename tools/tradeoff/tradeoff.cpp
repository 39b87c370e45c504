// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/tradeoff/tradeoff.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/scene/scene.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::Variant;

enum class RunStatus { fresh, started, done, failed };

/// A summary made with other settings than the variant's says that the folder belongs to another study.
void require_same(const core::JsonValue& summary, const Variant& variant, const std::string& case_path,
                  const std::string& folder) {
  const forming::Scene scene = forming::read_scene(case_path, variant.accuracy, variant.overrides);
  const auto* numerics = summary.find("numerics");
  bool same = numerics && summary.find("case_fingerprint") &&
              summary.text_of("case_fingerprint") == core::fingerprint_text(scene.fingerprint);
  for (const forming::Setting& setting : forming::settings())
    same = same && numerics->number_of(setting.key) == scene.accuracy.*setting.value;
  if (!same)
    throw core::CaseError(
        fmt::format("{}: a run of another case or of other settings was found, allowed is an --output folder of "
                    "this study of the case as it is now",
                    folder));
}

RunStatus run_status(const Variant& variant, const std::string& case_path, const std::string& folder) {
  if (const auto summary = core::read_json_file(folder + "/summary.json")) {
    require_same(*summary, variant, case_path, folder);
    if (summary->flag_of("completed")) return RunStatus::done;
    if (!summary->flag_of("stopped")) return RunStatus::failed;
  }
  if (forming::has_checkpoint(folder)) return RunStatus::started;
  return RunStatus::fresh;
}

constexpr double long_run = 60;  ///< CPU seconds above which a variant is run once

/// A variant to run: for its results, or once more for its CPU time alone.
struct Task {
  std::size_t variant;
  int round;  ///< 0 for the results
};

struct Running {
  Task task;
  int child;
};

struct Study {
  const TradeoffRequest& request;
  std::vector<Variant> variants;
  std::vector<Task> tasks;
  std::vector<Running> running;
  std::size_t next = 0, ended = 0;

  std::string folder(const Variant& variant) const { return request.output + '/' + variant.name; }
};

std::string timing_folder(const std::string& folder) {
  return folder + ".again";
}

double cpu_of(const std::string& folder) {
  const auto summary = core::read_json_file(folder + "/summary.json");
  return summary && summary->flag_of("completed") ? summary->number_of("cpu_seconds") : 0;
}

void say(const Study& study, const Variant& variant, const std::string& what) {
  fmt::print("[{:2}/{}] {:<28} {}\n", study.ended, study.tasks.size(), variant.name, what);
  std::fflush(stdout);
}

std::string result_line(const Study& study, const Variant& variant) {
  const auto summary = core::read_json_file(study.folder(variant) + "/summary.json");
  if (!summary && stop_requested()) return "stopped before its first checkpoint, will start anew";
  if (!summary) return fmt::format("ended without a summary, see {}.log", study.folder(variant));
  return summary->flag_of("completed") ? fmt::format("{:.1f} s CPU", summary->number_of("cpu_seconds"))
         : summary->flag_of("stopped") ? "stopped in " + summary->text_of("reason")
                                       : fmt::format("failed: {}", summary->text_of("reason"));
}

std::vector<std::string> run_arguments(const Study& study, const Variant& variant, const std::string& folder) {
  std::vector<std::string> arguments = {"run",  study.request.case_path, "--accuracy", variant.accuracy, "--output",
                                        folder, "--later-counts"};
  for (const std::string& assignment : variant.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  return arguments;
}

void start(Study& study, const Task& task, const std::vector<std::string>& arguments, const std::string& folder,
           const std::string& what) {
  study.running.push_back({task, start_self(arguments, folder + ".log")});
  say(study, study.variants[task.variant], what);
}

/// Starts a variant that has something left to do; false where it has not.
bool start_variant(Study& study, const Task& task) {
  const Variant& variant = study.variants[task.variant];
  const std::string folder = study.folder(variant);
  const RunStatus now = run_status(variant, study.request.case_path, folder);
  if (now == RunStatus::done || now == RunStatus::failed) {
    ++study.ended;
    say(study, variant, result_line(study, variant) + ", from before");
    return false;
  }
  if (now == RunStatus::started) {
    start(study, task, {"resume", folder}, folder, "goes on");
  } else {
    core::remove_own(folder);  // what was killed before its first checkpoint
    forget_timings(folder);
    start(study, task, run_arguments(study, variant, folder), folder, "starts");
  }
  return true;
}

/// Starts a further run of a short variant; false where its round was run before or its first run says that none is
/// wanted.
bool start_timing(Study& study, const Task& task) {
  const Variant& variant = study.variants[task.variant];
  const std::string folder = study.folder(variant), again = timing_folder(folder);
  const double cpu = cpu_of(folder);
  if (cpu == 0 || cpu > long_run || static_cast<int>(read_timings(folder).size()) >= task.round) {
    ++study.ended;
    return false;
  }
  core::remove_own(again);
  start(study, task, run_arguments(study, variant, again), again,
        fmt::format("runs for its time, {} of {}", task.round + 1, study.request.timings));
  return true;
}

/// Starts the next task that has something left to do; false when there is none.
bool start_next(Study& study) {
  while (study.next < study.tasks.size()) {
    const Task& task = study.tasks[study.next];
    // A first run that is still under way says later whether it was short.
    if (task.round > 0 && std::any_of(study.running.begin(), study.running.end(),
                                      [&](const Running& run) { return run.task.variant == task.variant; }))
      return false;
    ++study.next;
    if (task.round == 0 ? start_variant(study, task) : start_timing(study, task)) return true;
  }
  return false;
}

void collect_timing(Study& study, const Variant& variant) {
  const std::string folder = study.folder(variant), again = timing_folder(folder);
  const double cpu = cpu_of(again);
  if (cpu > 0) add_timing(folder, cpu);
  say(study, variant, cpu > 0 ? fmt::format("{:.1f} s CPU", cpu) : "stopped");
  core::remove_own(again);
  core::remove_own(again + ".log");
}

void collect_ended(Study& study) {
  for (std::size_t i = study.running.size(); i-- > 0;)
    if (has_ended(study.running[i].child)) {
      ++study.ended;
      const Task task = study.running[i].task;
      const Variant& variant = study.variants[task.variant];
      study.running.erase(study.running.begin() + static_cast<long>(i));
      if (task.round > 0)
        collect_timing(study, variant);
      else
        say(study, variant, result_line(study, variant));
    }
}

/// Runs what is left, as many at once as asked for; false when stopped on request.
bool run_study(Study& study) {
  bool requested = false;
  for (;;) {
    while (!stop_requested() && static_cast<int>(study.running.size()) < study.request.jobs && start_next(study)) {
    }
    if (stop_requested() && !requested) {
      requested = true;
      for (const Running& run : study.running) request_stop(run.child);
    }
    if (study.running.empty()) return !stop_requested();
    usleep(50000);
    collect_ended(study);
  }
}

bool wanted(const TradeoffRequest& request, const Variant& variant) {
  return request.groups.empty() || std::count(request.groups.begin(), request.groups.end(), variant.group);
}

/// The folder of the study, and in it those of runs that begin anew, before the first of them.
void claim(const Study& study) {
  std::set<std::string> names{"tradeoff.csv", "tradeoff.json", "tradeoff.md", "tradeoff.png", "tradeoff.svg"};
  for (const Variant& variant : study.variants)
    for (const char* ending : {"", ".log", ".timings", ".again", ".again.log"}) names.insert(variant.name + ending);
  core::claim_folder(study.request.output, "tradeoff", names);
  for (const Variant& variant : study.variants)
    if (run_status(variant, study.request.case_path, study.folder(variant)) == RunStatus::fresh)
      core::require_own(study.folder(variant));
}

/// The reference, the base, and the variants of the groups asked for.
std::vector<Variant> make_variants(const TradeoffRequest& request, const forming::Scene& scene, std::string& base) {
  std::vector<Variant> all = request.study.empty() ? forming::standard_study(scene, request.reference)
                                                   : forming::read_study(request.study, request.base);
  if (all.empty())
    throw core::CaseError(fmt::format("{}: no [[variant]] was found, allowed is at least one", request.study));
  std::set<std::string> groups;
  for (const Variant& variant : all) groups.insert(variant.group);
  for (const std::string& group : request.groups)
    if (!groups.count(group))
      throw core::CaseError(fmt::format("--only: \"{}\" was found, allowed are {}", group, fmt::join(groups, ", ")));
  base = forming::base_variant(all, request.base);
  std::vector<Variant> variants = {{"reference", "reference", request.reference, {}, ""}};
  for (const Variant& variant : all)
    if (variant.name == base || wanted(request, variant)) variants.push_back(variant);
  for (Variant& variant : variants)
    variant.overrides.insert(variant.overrides.begin(), request.overrides.begin(), request.overrides.end());
  return variants;
}

}  // namespace

int tradeoff(const TradeoffRequest& given) {
  catch_signals();
  TradeoffRequest request = given;
  const forming::Scene scene = forming::read_scene(request.case_path, request.base, request.overrides);
  if (request.reference.empty()) request.reference = forming::usual_reference(scene);
  if (request.output.empty()) request.output = "results/tradeoff_" + scene.name;
  std::string base;
  Study study{request, make_variants(request, scene, base), {}, {}};
  for (int round = 0; round < request.timings; ++round)
    for (std::size_t variant = 0; variant < study.variants.size(); ++variant) study.tasks.push_back({variant, round});
  for (const Variant& variant : study.variants) {
    forming::read_scene(request.case_path, variant.accuracy, variant.overrides);  // refused now, not hours later
    if (request.list)
      fmt::print("{:<28} {:<10} {:<22} {}\n", variant.name, variant.group, variant.accuracy,
                 fmt::join(variant.overrides, ", "));
  }
  if (request.list) return 0;
  claim(study);
  if (!run_study(study)) {
    fmt::print(stderr, "parison: the study was stopped on request; the same command goes on with it\n");
    return 1;
  }
  return report_tradeoff(request.output, study.variants, base, forming::model_sensitivity(scene)) ? 0 : 1;
}

}  // namespace parison::tools
