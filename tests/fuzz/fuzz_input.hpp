#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzz targets share. A target takes any bytes for a file that a user gives; it may refuse them by a CaseError
// or a RunError and must neither crash nor accept what is not finite.
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/mesh/profile.hpp"
#include "core/process/run_error.hpp"

namespace parison::tests {

/// A folder of this process for the file that is tried; gone when the process ends.
inline const std::string& fuzz_folder() {
  struct Folder {
    std::string path =
        (std::filesystem::temp_directory_path() / ("parison_fuzz_" + std::to_string(::getpid()))).string();
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path;
}

/// Writes the bytes into a file of the folder, then reads them by `read`.
template <typename Read>
int try_bytes(const std::uint8_t* data, std::size_t size, const std::string& name, const Read& read) {
  core::write_text(fuzz_folder() + '/' + name, std::string(reinterpret_cast<const char*>(data), size));
  try {
    read();
  } catch (const core::CaseError&) {
  } catch (const core::RunError&) {
  }
  return 0;
}

/// Ends the program where an outline that was accepted is not finite.
inline void require_finite(const core::Profile& profile) {
  double sum = core::signed_area(profile) + core::size(profile);
  for (const core::Segment& segment : profile.segments) sum += core::length(segment);
  if (!std::isfinite(sum)) std::abort();
}

}  // namespace parison::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
