#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// What lies in a folder, newest first; names are paths below it.
struct FolderContent {
  std::vector<std::string> cases;    ///< case files
  std::vector<std::string> results;  ///< folders of runs, of what-ifs and of searches
};

/// The folder that the workbench was opened with: nothing outside it is read or written, except the bundled cases,
/// which are only read.
class OpenFolder {
 public:
  explicit OpenFolder(const std::string& path);

  const std::string& path() const { return path_; }
  FolderContent content() const;
  /// The file or folder of a name, links followed. Throws core::CaseError where it is outside or not there.
  std::string existing(const std::string& name) const;
  /// The case file of a name: "jar/case.toml", or "bundled:jar".
  std::string case_file(const std::string& name) const;
  /// A place for a new folder directly in this one.
  std::string new_folder(const std::string& name) const;
  /// The first free name for results of a case, "results/jar_2"; its parent is made.
  std::string new_results(const std::string& case_name) const;

 private:
  std::string path_;
};

/// Whether a name is that of a bundled case, which is not changed.
bool is_bundled(const std::string& name);

}  // namespace parison::tools
