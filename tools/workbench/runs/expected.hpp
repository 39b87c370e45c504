#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/io/json.hpp"

namespace parison::tools {

/// A run that has come to its end: its name for the page, its folder.
struct EndedRun {
  std::string name, folder;
};

/// Adds, as `expected`, what a run of a case at each of some accuracies is expected to cost and to be off by:
/// `accuracy`; `error`, of the wall in the mean and of the heat into the tools, a share, by the law of the bundled
/// cases; `cpu_from_s` and `cpu_to_s`, CPU time by the known run whose accuracy is nearest (`by`, its name), the newest
/// of several coming first, else by the bundled containers. None of round glass say it for glass in space.
void add_expected(const std::string& case_file, const std::vector<std::string>& accuracies,
                  const std::vector<EndedRun>& known, core::JsonWriter& json);

}  // namespace parison::tools
