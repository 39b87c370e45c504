// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {

OpenCase& WorkbenchState::open(const std::string& name) {
  const std::string file = folder.case_file(name);
  auto& one = cases_[file];
  if (one)
    one->look();
  else
    one = std::make_unique<OpenCase>(file);
  return *one;
}

WatchedFolder& WorkbenchState::watched(const std::string& results) {
  const std::string path = folder.existing(results);
  auto& one = shown_[path];
  if (!one) one = std::make_unique<WatchedFolder>(path);
  return *one;
}

}  // namespace parison::tools
