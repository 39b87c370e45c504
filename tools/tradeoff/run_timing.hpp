#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// CPU times of the further runs of a variant, s, kept next to its folder. Throws core::CaseError where a line is no
/// time.
std::vector<double> read_timings(const std::string& folder);

/// Adds the CPU time of a further run, s.
void add_timing(const std::string& folder, double cpu);

/// Takes them away, as a variant that runs anew has none.
void forget_timings(const std::string& folder);

}  // namespace parison::tools
