#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <future>
#include <set>
#include <string>
#include <vector>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"
#include "core/mesh/interface_point.hpp"
#include "forming/report/files/history.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The fields of the glass in its VTU files: those declared in glass_fields, viscosity, wall thickness, heat flux.
core::VtuFields glass_output(const Scene& scene, const State& state);
/// Those of a tool: its temperature, and whether the stage names it.
core::VtuFields tool_output(const Scene& scene, const State& state, Index tool);

/// Heat flux by conduction with internal radiation, -k grad T, at the nodes, W/m2: core::dim numbers each, the mean
/// over the cells around by their volume. `wall_thickness`, m at the nodes, limits the radiation in thin walls.
Eigen::VectorXd conducted_flux(const core::Mesh& mesh, core::Geometry geometry, const thermal::Material& material,
                               const Eigen::VectorXd& temperature, const Eigen::VectorXd& wall_thickness);

/// How far the files of a run have come.
struct WrittenFiles {
  std::int64_t history_size = 0, tools_size = 0, interface_size = 0;  ///< bytes
  std::vector<double> output_times;                                   ///< of the VTU files, s
  std::int64_t solid_history_size = 0;                                ///< of glass in space, likewise
  std::vector<double> solid_output_times = {};                        ///< s
  double stage_lowest = 0;  ///< lowest_downwards at the start of the present stage, m
};

/// What a run leaves on its way beside its tables. A run that is stopped or fails writes its last fields and a
/// checkpoint all the same.
struct RunFiles {
  bool fields = true;             ///< VTU files and interface.csv
  bool stage_checkpoints = true;  ///< at the end of each stage; those by wall time and steps are always written
  /// Stages from whose end another run takes over: they have a checkpoint.
  std::set<std::string> shared_stages = {};
};

/// The files of a run in its result folder; they observe and never steer.
class ResultFiles {
 public:
  /// Makes the folder; throws core::CaseError where it exists and is not empty.
  ResultFiles(const Scene& scene, const std::string& directory);
  /// Continues in a folder from where its files were; whatever was written since is cut off.
  ResultFiles(const Scene& scene, const std::string& directory, const WrittenFiles& written);

  /// A row of history.csv and one of tools.csv; with the system when this returns.
  void row(const HistoryRow& row, const std::string& tools);
  /// VTU files of all bodies and the rows of interface.csv; a second call at the same time does nothing.
  void fields(const State& state, const std::vector<core::InterfacePoint>& interface);
  /// Flushes everything to the disk and returns how much has been written.
  WrittenFiles sync();

  const std::string& directory() const { return directory_; }

 private:
  /// Of an output's VTU file, in the result folder.
  std::string vtu_file(std::size_t body, std::size_t output) const;
  void remove_vtu_files_from(std::size_t output) const;
  void start_sync();

  const Scene& scene_;
  std::string directory_;
  core::GrowingFile history_, tools_, interface_;
  std::vector<core::PvdCollection> collections_;  ///< glass, then the tools
  std::vector<double> output_times_;
  std::size_t synced_ = 0;     ///< outputs on the disk or on their way
  std::future<void> syncing_;  ///< flushes the files of the last outputs to the disk while the run continues
};

}  // namespace parison::forming
