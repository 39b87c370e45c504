#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/study/production/cycle_run.hpp"
#include "forming/study/production/wanted_cooling.hpp"

namespace parison::forming {

/// What is asked of a search for the periodic state of production.
struct PeriodicRequest {
  double tolerance = 0.5;  ///< of any tool-surface temperature, K: its change in a cycle, its distance
  int max_runs = 12;       ///< forming runs of the search, after which two plain cycles still go on
  std::string directory;   ///< new folder: the first gob, the settled container and the state of the tools
  /// Folder of the tools of another production that the case changes; the first run is then the first container after
  /// the change. Empty: the search starts from the tools as the case has them.
  std::string changed_from = {};
  std::vector<CaseDifference> changes = {};  ///< in which the case differs from that of the other production
  std::vector<WantedTool> wanted = {};       ///< tools whose cooling is looked for with the state
};

/// A forming run of the search.
struct SearchRun {
  std::vector<double> change;    ///< of the surface of each tool over this cycle, K
  std::vector<double> distance;  ///< to the state that heat-only cycles with the heat of this run settle to, K
};

/// A cycle of the start of production, by heat-only cycles.
struct StartUpCycle {
  std::vector<double> mean;  ///< temperature of the surface of each tool at the gob, K
  double distance;           ///< largest of any tool surface to the settled state, K
};

/// Production of one container after another with the same tools.
struct PeriodicState {
  MachineCycle cycle;
  std::string failure;  ///< why the search or a run did not end well; empty where all did
  bool stopped = false;
  bool found = false;
  int runs = 0;                   ///< forming runs to the state found, without the plain cycles from there
  std::vector<Cooling> cooling;   ///< that gives the wanted temperatures
  std::vector<SearchRun> search;  ///< of all of them; the first is that of the first gob
  CycleRun first, settled;        ///< cycles from the temperatures of the case and from the state found
  std::vector<double> confirmed;  ///< change of any tool surface in each of two plain cycles from the state found, K
  double offset = 0;              ///< of any tool surface to the state that those cycles and the search say, K
  double uncertainty = 0;         ///< of that state, K; SettledEstimates::uncertainty
  std::vector<StartUpCycle> start_up;
  std::vector<double> swab_heat;         ///< of one swab of each tool, J; 0 for a tool without
  std::vector<StartUpCycle> since_swab;  ///< the cycles from one swab to the next; empty without
  std::optional<CycleRun> just_swabbed;  ///< the container made just after swabs of all tools that have them

  bool is_confirmed(double tolerance) const;
};

/// Told after each forming run, in words.
using Progress = std::function<void(const std::string&)>;

/// Looks for tool temperatures that a machine cycle gives back. Between forming runs heat-only cycles (HeatCycles) go
/// on to where they settle; that map is iterated, after two plain iterations with Anderson's acceleration. Where the
/// distances fall no more, what is left is the scatter of forming runs, and the mean of the states that they settle to
/// is taken until it is known to the tolerance (SettledEstimates). Two plain cycles from there confirm it: they change
/// no tool surface by more than the tolerance, and what they settle to, with the runs before, is no further away, which
/// a tool that takes hundreds of cycles does not show by its change; more runs are made where single ones scatter too
/// much for that. Otherwise the search goes on. Each cycle has its
/// share of swabs; what happens from one to the next is found afterwards. Where tools have wanted temperatures, the
/// first forming runs find their cooling too (find_cooling), until the next one would change it no more; it then is
/// held.
PeriodicState find_periodic_state(const Scene& scene, const MachineCycle& cycle, const PeriodicRequest& request,
                                  const StopRequest& stop, const Progress& progress);

}  // namespace parison::forming
