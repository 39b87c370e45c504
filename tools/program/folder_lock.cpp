// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"

namespace parison::tools {

FolderLock::FolderLock(const std::string& folder) {
  const std::string path = folder + "/.lock";
  file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw core::SystemError(fmt::format("{}: cannot be written: {}", path, std::strerror(errno)), errno);
  constexpr unsigned poll_microseconds = 50000;
  constexpr int tries = 200;
  for (int i = 0; flock(file_, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (i == tries) {
      close(file_);
      throw core::RunError(
          fmt::format("{}: another process works on it, or one that was killed has not ended", folder));
    }
    usleep(poll_microseconds);
  }
}

FolderLock::~FolderLock() {
  close(file_);
}

FileLock::FileLock(std::string path) : path_(std::move(path)) {
  core::require_own(path_);
  core::note_growing(path_);
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) throw core::SystemError(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)), errno);
}

bool FileLock::is_held(double patience) {
  constexpr double pause = 0.1;  // s
  for (double waited = 0; flock(file_, LOCK_EX | LOCK_NB) != 0; waited += pause) {
    if (waited >= patience) return false;
    usleep(static_cast<useconds_t>(1e6 * pause));
  }
  return true;
}

FileLock::~FileLock() {
  close(file_);
}

void FileLock::remove() {
  unlink(path_.c_str());
}

}  // namespace parison::tools
