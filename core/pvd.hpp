#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::core {

/// A ParaView collection: the files of a time series. The whole file is written at each addition, so it opens at any time.
class PvdCollection {
 public:
  struct Entry {
    double time;  ///< s
    std::string file;
  };

  explicit PvdCollection(std::string path) : path_(std::move(path)) {}
  /// `file` is relative to the collection's folder; time in s.
  void add(double time, const std::string& file);
  /// Has these entries and no others.
  void set(const std::vector<Entry>& entries);

 private:
  void append(const Entry& entry);
  void write() const;

  std::string path_, lines_;
};

}  // namespace parison::core
