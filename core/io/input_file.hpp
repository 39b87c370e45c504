#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>
#include <vector>

namespace parison::core {

/// The largest file that is read as a case, a drawing or a table, bytes.
inline constexpr std::size_t max_input_bytes = 100'000'000;

/// A file that was given to the program.
struct InputFile {
  std::string content;
  std::string problem;  ///< empty, or why it was not read: "is not a regular file, allowed is ..."
};

/// The whole of a regular file of up to `max_bytes` bytes. It never waits for a writer, as on a pipe, and never takes
/// more memory than `max_bytes`.
InputFile read_input_file(const std::string& path, std::size_t max_bytes = max_input_bytes);

/// A file as it was when it was read.
struct ReadFile {
  std::string path;  ///< absolute
  std::string content;
};

/// Keeps what read_input_file reads in this thread while it lives, each file once, in the order of the first reading.
class ReadRecord {
 public:
  ReadRecord();
  ReadRecord(const ReadRecord&) = delete;
  ~ReadRecord();
  std::vector<ReadFile> files;

 private:
  ReadRecord* outer_;
};

}  // namespace parison::core
