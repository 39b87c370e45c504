#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::forming {

/// A value in which two cases differ, as a user reads it; empty where one of them does not have it.
struct CaseDifference {
  std::string key, before, now;
};

/// All values in which two case files with these assignments differ.
std::vector<CaseDifference> case_differences(const std::string& before,
                                             const std::vector<std::string>& overrides_before, const std::string& now,
                                             const std::vector<std::string>& overrides_now);

/// Two case files with assignments, with the bundled materials that either names, without tolerances, which no run
/// uses.
std::pair<core::CaseFile, core::CaseFile> comparable_cases(const std::string& before,
                                                           const std::vector<std::string>& overrides_before,
                                                           const std::string& now,
                                                           const std::vector<std::string>& overrides_now);

/// Of an item of two case files, by its name; of an entry of two lists, by its number; of the first `count` entries of
/// two lists, and of their number below that.
std::vector<CaseDifference> item_differences(const core::CaseNode& before, const core::CaseNode& now,
                                             const std::string& item);
std::vector<CaseDifference> entry_differences(const core::CaseNode& before, const core::CaseNode& now,
                                              std::size_t number);
std::vector<CaseDifference> first_entry_differences(const core::CaseNode& before, const core::CaseNode& now,
                                                    std::size_t count);

}  // namespace parison::forming
