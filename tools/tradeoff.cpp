// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/tradeoff.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/scene/scene.hpp"
#include "tools/child_process.hpp"
#include "tools/run_timing.hpp"
#include "tools/stop_request.hpp"
#include "tools/tradeoff_report.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::Rung;

enum class Standing { fresh, begun, done, failed };

/// A summary made with other settings than the rung's says that the folder belongs to another ladder.
void require_same(const core::JsonValue& summary, const Rung& rung, const std::string& case_path,
                  const std::string& folder) {
  const forming::Scene scene = forming::read_scene(case_path, rung.accuracy, rung.overrides);
  const auto* numerics = summary.find("numerics");
  bool same = numerics && summary.find("case_fingerprint") &&
              summary.text_of("case_fingerprint") == core::fingerprint_text(scene.fingerprint);
  for (const forming::Setting& setting : forming::settings())
    same = same && numerics->number_of(setting.key) == scene.accuracy.*setting.value;
  if (!same)
    throw core::CaseError(
        fmt::format("{}: a run of another case or of other settings was found, allowed is an --output folder of "
                    "this ladder of the case as it is now",
                    folder));
}

Standing standing(const Rung& rung, const std::string& case_path, const std::string& folder) {
  const std::string path = folder + "/summary.json";
  if (fs::exists(path)) {
    const core::JsonValue summary = core::read_json(core::read_text(path), path);
    require_same(summary, rung, case_path, folder);
    if (summary.flag_of("completed")) return Standing::done;
    if (!summary.flag_of("stopped")) return Standing::failed;
  }
  if (forming::has_checkpoint(folder)) return Standing::begun;
  return Standing::fresh;
}

constexpr double long_run = 60;  ///< CPU seconds above which a rung is run once

/// A rung to run: for its results, or once more for its CPU time alone.
struct Task {
  std::size_t rung;
  int round;  ///< 0 for the results
};

struct Running {
  Task task;
  int child;
};

struct Ladder {
  const TradeoffRequest& request;
  std::vector<Rung> rungs;
  std::vector<Task> tasks;
  std::vector<Running> running;
  std::size_t next = 0, ended = 0;

  std::string folder(const Rung& rung) const { return request.output + '/' + rung.name; }
};

std::string timing_folder(const std::string& folder) {
  return folder + ".again";
}

double cpu_of(const std::string& folder) {
  const std::string path = folder + "/summary.json";
  if (!fs::exists(path)) return 0;
  const core::JsonValue summary = core::read_json(core::read_text(path), path);
  return summary.flag_of("completed") ? summary.number_of("cpu_seconds") : 0;
}

void say(const Ladder& ladder, const Rung& rung, const std::string& what) {
  fmt::print("[{:2}/{}] {:<28} {}\n", ladder.ended, ladder.tasks.size(), rung.name, what);
  std::fflush(stdout);
}

std::string result_line(const Ladder& ladder, const Rung& rung) {
  const std::string path = ladder.folder(rung) + "/summary.json";
  if (!fs::exists(path) && stop_asked()) return "stopped before its first checkpoint, will start anew";
  if (!fs::exists(path)) return fmt::format("ended without a summary, see {}.log", ladder.folder(rung));
  const core::JsonValue summary = core::read_json(core::read_text(path), path);
  return summary.flag_of("completed") ? fmt::format("{:.1f} s CPU", summary.number_of("cpu_seconds"))
         : summary.flag_of("stopped") ? "stopped"
                                      : fmt::format("failed: {}", summary.text_of("reason"));
}

std::vector<std::string> run_arguments(const Ladder& ladder, const Rung& rung, const std::string& folder) {
  std::vector<std::string> arguments = {"run", ladder.request.case_path, "--accuracy", rung.accuracy, "--output",
                                        folder};
  for (const std::string& assignment : rung.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  return arguments;
}

void start(Ladder& ladder, const Task& task, const std::vector<std::string>& arguments, const std::string& folder,
           const std::string& what) {
  ladder.running.push_back({task, start_self(arguments, folder + ".log")});
  say(ladder, ladder.rungs[task.rung], what);
}

/// Starts a rung that has something left to do; false where it has not.
bool start_rung(Ladder& ladder, const Task& task) {
  const Rung& rung = ladder.rungs[task.rung];
  const std::string folder = ladder.folder(rung);
  const Standing now = standing(rung, ladder.request.case_path, folder);
  if (now == Standing::done || now == Standing::failed) {
    ++ladder.ended;
    say(ladder, rung, result_line(ladder, rung) + ", from before");
    return false;
  }
  if (now == Standing::begun) {
    start(ladder, task, {"resume", folder}, folder, "goes on");
  } else {
    fs::remove_all(folder);  // what was killed before its first checkpoint
    forget_timings(folder);
    start(ladder, task, run_arguments(ladder, rung, folder), folder, "starts");
  }
  return true;
}

/// Starts a further run of a short rung; false where its round was run before or its first run says that none is
/// wanted.
bool start_timing(Ladder& ladder, const Task& task) {
  const Rung& rung = ladder.rungs[task.rung];
  const std::string folder = ladder.folder(rung), again = timing_folder(folder);
  const double cpu = cpu_of(folder);
  if (cpu == 0 || cpu > long_run || static_cast<int>(read_timings(folder).size()) >= task.round) {
    ++ladder.ended;
    return false;
  }
  fs::remove_all(again);
  start(ladder, task, run_arguments(ladder, rung, again), again,
        fmt::format("runs for its time, {} of {}", task.round + 1, ladder.request.timings));
  return true;
}

/// Starts the next task that has something left to do; false when there is none.
bool start_next(Ladder& ladder) {
  while (ladder.next < ladder.tasks.size()) {
    const Task& task = ladder.tasks[ladder.next];
    // A first run that is still under way says later whether it was short.
    if (task.round > 0 && std::any_of(ladder.running.begin(), ladder.running.end(),
                                      [&](const Running& run) { return run.task.rung == task.rung; }))
      return false;
    ++ladder.next;
    if (task.round == 0 ? start_rung(ladder, task) : start_timing(ladder, task)) return true;
  }
  return false;
}

void collect_timing(Ladder& ladder, const Rung& rung) {
  const std::string folder = ladder.folder(rung), again = timing_folder(folder);
  const double cpu = cpu_of(again);
  if (cpu > 0) add_timing(folder, cpu);
  say(ladder, rung, cpu > 0 ? fmt::format("{:.1f} s CPU", cpu) : "stopped");
  fs::remove_all(again);
  fs::remove(again + ".log");
}

void collect_ended(Ladder& ladder) {
  for (std::size_t i = ladder.running.size(); i-- > 0;)
    if (has_ended(ladder.running[i].child)) {
      ++ladder.ended;
      const Task task = ladder.running[i].task;
      const Rung& rung = ladder.rungs[task.rung];
      ladder.running.erase(ladder.running.begin() + static_cast<long>(i));
      if (task.round > 0)
        collect_timing(ladder, rung);
      else
        say(ladder, rung, result_line(ladder, rung));
    }
}

/// Runs what is left, as many at once as asked for; false when told to stop.
bool climb(Ladder& ladder) {
  bool told = false;
  for (;;) {
    while (!stop_asked() && static_cast<int>(ladder.running.size()) < ladder.request.jobs && start_next(ladder)) {
    }
    if (stop_asked() && !told) {
      told = true;
      for (const Running& run : ladder.running) ask_to_stop(run.child);
    }
    if (ladder.running.empty()) return !stop_asked();
    usleep(50000);
    collect_ended(ladder);
  }
}

bool wanted(const TradeoffRequest& request, const Rung& rung) {
  return request.groups.empty() || std::count(request.groups.begin(), request.groups.end(), rung.group);
}

/// The reference, the base, and the rungs of the groups asked for.
std::vector<Rung> make_rungs(const TradeoffRequest& request, const forming::Scene& scene, std::string& base) {
  std::vector<Rung> all = request.ladder.empty() ? forming::standard_ladder(scene, request.reference)
                                                 : forming::read_ladder(request.ladder, request.base);
  if (all.empty())
    throw core::CaseError(fmt::format("{}: no [[rung]] was found, allowed is at least one", request.ladder));
  std::set<std::string> groups;
  for (const Rung& rung : all) groups.insert(rung.group);
  for (const std::string& group : request.groups)
    if (!groups.count(group))
      throw core::CaseError(fmt::format("--only: \"{}\" was found, allowed are {}", group, fmt::join(groups, ", ")));
  base = forming::base_rung(all, request.base);
  std::vector<Rung> rungs = {{"reference", "reference", request.reference, {}, ""}};
  for (const Rung& rung : all)
    if (rung.name == base || wanted(request, rung)) rungs.push_back(rung);
  for (Rung& rung : rungs)
    rung.overrides.insert(rung.overrides.begin(), request.overrides.begin(), request.overrides.end());
  return rungs;
}

}  // namespace

int tradeoff(const TradeoffRequest& given) {
  catch_signals();
  TradeoffRequest request = given;
  const forming::Scene scene = forming::read_scene(request.case_path, request.base, request.overrides);
  if (request.reference.empty()) request.reference = forming::usual_reference(scene);
  if (request.output.empty()) request.output = "results/tradeoff_" + scene.name;
  std::string base;
  Ladder ladder{request, make_rungs(request, scene, base), {}, {}};
  for (int round = 0; round < request.timings; ++round)
    for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung) ladder.tasks.push_back({rung, round});
  for (const Rung& rung : ladder.rungs) {
    forming::read_scene(request.case_path, rung.accuracy, rung.overrides);  // refused now, not hours later
    if (request.list)
      fmt::print("{:<28} {:<10} {:<22} {}\n", rung.name, rung.group, rung.accuracy, fmt::join(rung.overrides, ", "));
  }
  if (request.list) return 0;
  if (fs::exists(request.output + "/summary.json"))
    throw core::CaseError(fmt::format(
        "{}: the results of a run were found, allowed is a folder of its own for a ladder", request.output));
  fs::create_directories(request.output);
  if (!climb(ladder)) {
    fmt::print(stderr, "parison: the ladder was told to stop; the same command goes on with it\n");
    return 1;
  }
  return report_tradeoff(request.output, ladder.rungs, base, forming::estimate_parts(scene)) ? 0 : 1;
}

}  // namespace parison::tools
