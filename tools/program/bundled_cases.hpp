#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <string>
#include <vector>

namespace parison::tools {

/// A file or folder of share/parison (`cases`, `tools`) of the running program, installed or in its build folder; empty
/// where there is none.
std::filesystem::path shared_file(const std::string& name);

/// The path as given where it exists or is more than a name, else that of the bundled case of this name.
/// A name of neither is refused with the names there are.
std::string find_case(const std::string& given);

/// The case that a file names: beside the file where it is there, else as every command finds it.
std::string case_named(const std::string& directory, const std::string& given);

/// A bundled case with the title of its README, and its picture, a path that is empty where there is none.
struct BundledCase {
  std::string name, title, picture;
};
std::vector<BundledCase> bundled_cases();

/// A line for each bundled case, its name and the title of its README, and their folder.
std::string bundled_cases_table();

}  // namespace parison::tools
