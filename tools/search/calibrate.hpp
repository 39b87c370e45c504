#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/search/calibration/calibration.hpp"

namespace parison::tools {

/// What `parison calibrate` is asked for.
struct CalibrateRequest {
  std::string case_path, accuracy = "draft", output;
  std::vector<std::string> data, overrides, varied;
  std::string temperature_noise = "1 K", thickness_noise = "0.05 mm", position_noise = "0.1 mm", force_noise = "10 N";
  std::size_t runs = 100;
  int jobs = 0;  ///< 0: as many as there are cores
  /// The pressure-viscosity law alone: CSV file, "NAME=VALUE" of what is not fitted; residuals weighed as shares.
  std::string law;
  std::vector<std::string> fixed;
  bool relative = false;
};

/// Fits constants of a case to measurements, or goes on with it: intervals, and what the data cannot tell. Returns the
/// exit code.
int calibrate(const CalibrateRequest& request);

/// Fits the pressure-viscosity law to measured conductances or fluxes, the viscosity that of the case's glass where
/// they give none. Prints constants with their intervals, residuals, warnings, the lines for a case file; 0.
int calibrate_law(const CalibrateRequest& request);

}  // namespace parison::tools
