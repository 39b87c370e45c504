// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/tradeoff/run_timing.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"

namespace parison::tools {

namespace {

std::string path_of(const std::string& folder) {
  return folder + ".timings";
}

}  // namespace

std::vector<double> read_timings(const std::string& folder) {
  std::vector<double> seconds;
  if (!std::filesystem::exists(path_of(folder))) return seconds;
  std::istringstream lines(core::read_text(path_of(folder)));
  for (double value; lines >> value;) seconds.push_back(value);
  if (!lines.eof())
    throw core::CaseError(
        fmt::format("{}: a line without a number was found, allowed are CPU seconds", path_of(folder)));
  return seconds;
}

void add_timing(const std::string& folder, double cpu) {
  std::string text;
  for (const double seconds : read_timings(folder)) text += fmt::format("{:.6g}\n", seconds);
  core::replace_file(path_of(folder), text + fmt::format("{:.6g}\n", cpu));
}

void forget_timings(const std::string& folder) {
  core::remove_own(path_of(folder));
}

}  // namespace parison::tools
