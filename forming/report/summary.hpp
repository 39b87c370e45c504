#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "forming/diagnostics/diagnostics.hpp"
#include "forming/report/checks/check.hpp"
#include "forming/report/cooling/cold_container.hpp"
#include "forming/report/cooling/wall_stress.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/process/flags.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "forming/report/quantities.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// A stage as it went.
struct StageRecord {
  std::string name;
  double start, end;       ///< s since the start of the run
  std::string end_reason;  ///< name_of a StageEnd, "stop" or "failure"
  Work work = {};          ///< since the start of the run
};

/// What the time of a run is accumulated under.
inline constexpr std::array timed_parts{"flow", "heat", "radiation", "contact", "remesh", "output"};

/// What only the run itself knows.
struct RunFacts {
  bool completed = false;
  bool stopped = false;      ///< on request
  bool interrupted = false;  ///< by the system, as by a full disk: it can go on like one that was stopped
  std::string reason;        ///< why not, a sentence; empty when completed
  double wall_seconds = 0;
  double cpu_seconds = 0;                ///< of the whole process
  std::map<std::string, double> timing;  ///< s by part
  std::vector<std::string> warnings;
  Checks checks;  ///< of the run's end
  Diagnostics diagnostics;
  MouldFilling filling;  ///< at the end of the last stage that blew
  std::string unfilled;  ///< what the press has not filled, and why, a sentence; empty where it has
  std::vector<StageRecord> stages;
};

struct SolidState;

struct RunOutcome {
  State state;  ///< of a run whose glass became a solid: the parison, at the clock of the end
  RunFacts facts;
  std::shared_ptr<SolidState> solid = {};  ///< null where the glass was round to the end
};

struct ToolSummary {
  std::string name;
  double heat_received;                    ///< J
  std::optional<double> from_enclosure;    ///< light from other surfaces to its open ones, J; none without an enclosure
  std::optional<double> radiated;          ///< the part of it that came as light, J; none without light in bands
  std::optional<double> energy_imbalance;  ///< see energy_imbalance; none where the tool carries no heat
  Extreme hottest;                         ///< of its contact surface; NaN where it has none or carries no heat
  double position, force;                  ///< m, N
  std::vector<std::pair<std::string, double>> faces;  ///< boundaries with cooling or a given temperature, heat out, J
};

/// Heat that the glass has given off, J; of it as light to the surroundings.
struct HeatLost {
  double to_tools, to_air, light_to_air;
};

/// The results of a run in numbers.
struct Summary {
  RunFacts run;
  GlassFacts glass;
  std::vector<ToolSummary> tools;
  ThicknessRange thickness;             ///< m
  ThicknessRange beside_finish;         ///< the same, where tools grip the glass left out
  std::string no_wall;                  ///< why there is no thickness, a sentence; empty with one
  std::vector<WallStress> wall_stress;  ///< of a container that was cooled
  HeatLost heat_lost;
  std::optional<double> capacity_in_space;  ///< of a container that is not round, to its rim, m3
  double outer_within_02mm;                 ///< share of the outer surface within 0.2 mm of an active tool
  std::optional<CooledContainer> cold;      ///< of a container that has cooled
  FlagsRaised flags;
  Quantities quantities;
};
/// Of glass in space where there is `solid`.
Summary summarise(const Scene& scene, const State& state, const RunFacts& run, const ThicknessProfile& profile,
                  const SolidState* solid = nullptr);

/// Writes thickness.csv, contour.csv, heights.csv, of a cooled container residual_stress.csv, and summary.json into the
/// result folder; of glass in space summary.json alone, and the files of write_solid_summary.
Summary write_summary(const std::string& directory, const Scene& scene, const RunOutcome& outcome);
/// Writes summary.json again, now with error bars.
struct ErrorBars;
void add_error_bars(const std::string& directory, const Scene& scene, const State& state, const ErrorBars& bars,
                    Summary& summary);

/// Each quantity of interest with its estimated error, and whether the target was met.
std::string error_table(const ErrorBars& bars);

/// What a process engineer asks for, as a table for the terminal.
std::string summary_table(const Scene& scene, const State& state, const Summary& summary);
/// Its last line: what the checks of the run say together.
std::string verdict_line(const Summary& summary);

}  // namespace parison::forming
