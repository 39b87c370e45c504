#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

struct CameraRequest {
  std::string results;             ///< folder
  std::vector<std::string> bands;  ///< wavelengths from and to of each, "3 um", "5 um"; empty: two usual ones
  std::string time;                ///< empty: the end
  std::string surroundings;        ///< empty: the ambient of the stage
  std::string pixel = "0.5 mm";
  std::string output;  ///< name of the files without their ending; empty: camera in the result folder
};

/// Writes what an infrared camera beside the container sees: apparent temperature over height as CSV, and a picture of
/// each band as SVG. Returns the exit code.
int camera(const CameraRequest& request);

}  // namespace parison::tools
