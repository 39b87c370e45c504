#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/io/json.hpp"

namespace parison::tools {

/// A coarse run of the case as it is now, for the eye, in memory: only the last one is kept.
class Sketch {
 public:
  Sketch();
  ~Sketch();
  Sketch(const Sketch&) = delete;

  /// Begins one in place of that which may go on.
  void start(const std::string& case_file, long version);
  /// The folder of the last one, where it is of a case and has ended; else empty.
  std::string ended_of(const std::string& case_file);
  /// The version that is sketched, whether that goes on, the outline of its glass and its wall, or why there is none.
  /// `wanted_file`: a table of the wanted wall, or empty.
  void add_state(const std::string& wanted_file, core::JsonWriter& json);

 private:
  void end_child();

  std::string output() const;

  std::string folder_, case_file_;
  int child_ = 0, count_ = 0;
  long version_ = 0;
};

/// Adds the outline of the finished glass, mm, and its wall from the files of a result folder, beside a wanted one
/// (add_wall_band); nothing without them.
void add_finished_wall(const std::string& folder, const std::string& wanted_file, core::JsonWriter& json);

}  // namespace parison::tools
