#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <functional>
#include <string>

namespace parison::core {

/// The whole of a file. Like all functions here it throws RunError with the path where the system refuses.
std::string read_text(const std::string& path);
void write_text(const std::string& path, const std::string& text);

/// Replaces a file atomically: `write` makes it under a temporary name, then it is renamed. A reader sees the old file
/// or the new one.
void replace_file(const std::string& path, const std::function<void(const std::string& temporary)>& write);
void replace_file(const std::string& path, const std::string& text);

/// Returns when the file, or what a folder lists, is on the disk (fsync).
void sync_to_disk(const std::string& path);

/// A text file that is appended to; one process at a time may have it open.
class GrowingFile {
 public:
  /// Opens it with its first `size` bytes, cutting off what follows; 0 makes it where there is none.
  GrowingFile(std::string path, std::int64_t size);
  GrowingFile(const GrowingFile&) = delete;
  ~GrowingFile();

  /// Returns when the system has the text; where it takes only a part, none of it is left and RunError says why.
  void append(const std::string& text);
  std::int64_t size() const { return size_; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
  int file_;
  std::int64_t size_;
};

/// A text as one field of a CSV line, in quotes where it needs them.
std::string csv_text(const std::string& text);

/// FNV-1a hash of a text.
std::uint64_t fingerprint(const std::string& text);
/// A fingerprint as 16 digits.
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace parison::core
