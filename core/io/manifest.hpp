#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <vector>

namespace parison::core {

inline constexpr const char* reserved_prefix = ".parison_";
inline constexpr const char* manifest_name = ".parison_written";

/// A content that a file of the program has had.
struct NotedContent {
  bool grows = false;                       ///< it has whatever content
  std::uint64_t size = 0;                   ///< bytes
  std::vector<std::uint64_t> digests = {};  ///< FNV-1a of its first 1, 4, 16 ... bytes and, last, of all

  /// Of a whole content.
  static NotedContent of(const std::string& content);
  /// Whether a file has it, or what a loss of power has left of it: a beginning.
  bool fits(const std::string& file) const;
};

/// Those that the manifest of a folder has for a file, the latest last.
std::vector<NotedContent> contents_noted(const std::string& folder, const std::string& name);

/// The command whose results a folder is for; empty for none.
std::string kind_noted(const std::string& folder);

/// Adds a line to the manifest of a folder, which it makes. Where another user's manifest refuses it, as in /tmp, the
/// file is not the program's own: it is written once and not overwritten.
void note_content(const std::string& folder, const std::string& name, const NotedContent& content,
                  bool on_disk = false);
void note_kind(const std::string& folder, const std::string& kind);

}  // namespace parison::core
