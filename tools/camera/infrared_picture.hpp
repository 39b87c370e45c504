#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// What a camera sees in one band: apparent temperatures, degC, from the axis outwards in each row, the rows from the
/// lowest height up; not a number where there is no glass.
struct InfraredImage {
  std::string title;
  double pixel, low;  ///< size, and height of the lowest row's middle, mm
  std::vector<std::vector<double>> rows;
};

/// Images side by side as SVG, each with its own scale, both halves drawn.
std::string infrared_picture(const std::vector<InfraredImage>& images, const std::string& caption);

}  // namespace parison::tools
