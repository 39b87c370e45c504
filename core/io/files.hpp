#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <string_view>

namespace parison::core {

/// The whole of a file. Like all functions here it throws SystemError with the path where the system refuses.
std::string read_text(const std::string& path);
/// Writes a file that nobody else has; what may be a user's goes through replace_file.
void write_text(const std::string& path, const std::string& text);

/// How far a file has got when its writing returns: the disk itself (fsync of file and folder), or the system, which
/// brings it there later.
enum class Reach { disk, system };

/// Replaces a file of the program's own atomically, and notes it in the manifest of its folder (written_files.hpp). A
/// reader sees the old file or the new one, also after a loss of power. Throws CaseError where the file is a user's.
void replace_file(const std::string& path, const std::string& text, Reach reach = Reach::disk);

/// Returns when the file, or what a folder lists, is on the disk (fsync).
void sync_to_disk(const std::string& path);

/// A text file of the program's own that is appended to; one process at a time may have it open.
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
  std::uint64_t digest_ = 0;
};

/// A text as one field of a CSV line, in quotes where it needs them.
std::string csv_text(const std::string& text);

/// FNV-1a hash of a text, or of one that goes on after another with the hash `before`.
std::uint64_t fingerprint(std::string_view text, std::uint64_t before = 0xcbf29ce484222325u);
/// A fingerprint as 16 digits.
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace parison::core
