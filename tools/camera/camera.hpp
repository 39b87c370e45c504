#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// What a camera sees in one band: apparent temperatures, degC, from the axis outwards in each row, the rows from the
/// lowest z up; not a number where there is no glass.
struct InfraredImage {
  std::string title;
  double pixel, low;  ///< size, and height of the lowest row's middle, mm
  std::vector<std::vector<double>> rows;
  bool upright = true;  ///< false: +z is down
};

/// Images side by side as SVG, as the container stands, each with its own scale, both halves drawn. The scale is that
/// of the pixels with glass all around: a line of sight along the edge of the glass sees little of it.
std::string infrared_picture(const std::vector<InfraredImage>& images, const std::string& caption);

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
