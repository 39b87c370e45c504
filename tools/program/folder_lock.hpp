#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// Keeps a folder to this process and the copies that it starts of itself, until the last of them has ended. Waits for
/// another holder, whose copies may still be about to stop, for some seconds, then throws core::RunError.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  FolderLock(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int file_;
};

}  // namespace parison::tools
