#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace parison::tests {

/// What the tests of this program write; gone when it ends.
struct Scratch {
  const ::pid_t owner = ::getpid();
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / ("parison_" + std::to_string(owner));
  ~Scratch() {
    std::error_code ignored;
    if (::getpid() == owner) std::filesystem::remove_all(path, ignored);
  }
};

/// Where the running test keeps its files of one kind.
inline std::filesystem::path folder_of_test(const std::string& kind) {
  static const Scratch scratch;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return scratch.path / (std::string(test->test_suite_name()) + '_' + test->name()) / kind;
}

/// A folder that does not exist yet.
inline std::string absent_folder() {
  const auto folder = folder_of_test("results");
  std::filesystem::remove_all(folder);
  return folder.string();
}

/// A new folder without a file.
inline std::string new_folder() {
  const std::string folder = absent_folder();
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace parison::tests
