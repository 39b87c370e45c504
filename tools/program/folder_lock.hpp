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

/// A file by which one process at a time does something, also between the machines of a cluster that share its folder;
/// it is made where it is not there. Throws core::RunError where it cannot be made.
class FileLock {
 public:
  explicit FileLock(std::string path);
  FileLock(const FileLock&) = delete;
  ~FileLock();

  /// Takes the lock, waiting so long for another holder, s; whether this process has it, until this object ends.
  bool is_held(double patience);

  /// Removes the file. Who has it open already gets the lock when this one goes, and must then see that all is done.
  void remove();

 private:
  std::string path_;
  int file_;
};

}  // namespace parison::tools
