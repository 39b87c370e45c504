#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/io/files.hpp"
#include "core/io/vtu.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

/// The files of glass in space, in the folder `solid` of a result: fields of glass and tools for ParaView, history.csv,
/// and at the end wall.csv, meridians.csv, wall.svg and summary.json. They observe and never steer.
class SolidFiles {
 public:
  /// Removes what an earlier run of the same case left there, but for what `written` says a run that is taken up again
  /// had written.
  SolidFiles(const Scene& scene, const std::string& result, const SolidState& solid, const WrittenFiles& written = {});

  /// A row of history.csv.
  void row(const State& clock, const SolidState& solid);
  /// VTU files of all bodies.
  void fields(const State& clock, const SolidState& solid);

  /// Adds how much has been written, which is on the disk then.
  void note(WrittenFiles& written) const;

 private:
  std::string file(std::size_t body, std::size_t output) const;

  const Scene& scene_;
  std::string directory_;
  std::vector<std::string> names_;  ///< of the bodies: the glass, then the tools
  std::vector<core::PvdCollection> collections_;
  core::GrowingFile history_;
  std::vector<double> output_times_;  ///< s
};

/// Writes wall.csv, meridians.csv, wall.svg and summary.json of a solid that has ended.
void write_solid_summary(const Scene& scene, const std::string& result, const SolidState& solid, const SolidWall& wall);
/// The wall of a container in space as lines for the terminal.
std::string solid_table(const Scene& scene, const SolidState& solid, const SolidWall& wall);

}  // namespace parison::forming
