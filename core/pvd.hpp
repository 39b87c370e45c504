#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::core {

/// A ParaView collection: the files of a time series. The whole file is written at each addition, so it opens at any time.
class PvdCollection {
 public:
  explicit PvdCollection(std::string path) : path_(std::move(path)) {}
  /// `file` is relative to the collection's folder; time in s.
  void add(double time, const std::string& file);

 private:
  struct Entry {
    double time;
    std::string file;
  };
  std::string path_;
  std::vector<Entry> entries_;
};

}  // namespace parison::core
