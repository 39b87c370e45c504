#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::tools {

/// What `parison cycle` is asked for.
struct CycleRequest {
  std::string case_path, accuracy = "standard", output, cycle_time, tolerance = "0.5 K";
  std::vector<std::string> overrides;
  std::vector<std::string> sets;    ///< "ring=2": tools of which sets take turns
  std::vector<std::string> wanted;  ///< "blank=450 degC": what the surfaces of tools are to settle to
  int max_runs = 12;
  bool error_bars = false;  ///< of the differences between the first gob's container and the settled one
  int jobs = 1;             ///< runs of the error bars at once
  std::vector<forming::WhatIfVariant> variants = {};  ///< changes, each with production of its own
};

/// Looks for the tool temperatures of settled production and prints what the container becomes there; with variants,
/// what each of them changes there. Returns the exit code.
int cycle(const CycleRequest& request);

}  // namespace parison::tools
