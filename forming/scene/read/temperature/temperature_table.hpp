#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Temperatures over a grid of places; an axis of one value counts anywhere.
struct TemperatureGrid {
  std::vector<double> r, z;  ///< rising, m
  std::vector<double> T;     ///< K, row by row of z

  /// Linear between the points, that of the nearest beyond them, K.
  double operator()(const core::Point& x) const;
  /// Whether a place lies in the grid, or as near as that, m.
  bool covers(const core::Point& x, double near) const;
};

/// Share of a body that lies beyond the table of its temperatures at the start; 0 without one.
double share_beyond_table(const Body& body, core::Geometry geometry);

/// Temperatures of a CSV file with a heading such as r_mm,z_mm,T_degC: along r, along z, or a row for each point of a
/// grid of both in any order; linear between the points, that of the nearest beyond them.
StartField read_temperature_table(const core::CaseNode& node, const std::string& directory);

}  // namespace parison::forming
