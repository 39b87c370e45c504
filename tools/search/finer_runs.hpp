#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/search/search_result.hpp"

namespace parison::tools {

/// A row of a search that is to be run at the accuracy of `confirm`, and the name of its folder.
struct Finer {
  std::string name;
  std::size_t row;
};

/// Runs rows with error bars in a folder of the search's output and adds them to those that are confirmed; false where
/// stopped.
bool run_finer(const forming::Goal& goal, forming::SearchResult& result, const std::vector<Finer>& wanted,
               const std::string& output, const std::string& folder, int jobs);

}  // namespace parison::tools
