#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <functional>
#include <string>

namespace parison::core {

/// What work in a child process may take.
struct ChildLimits {
  int seconds = 30;                          ///< of the wall clock and of the processor
  std::size_t memory_bytes = 1'000'000'000;  ///< more than this process has
};

/// What came of work in a child process.
struct ChildWork {
  std::string text;
  std::string death;  ///< empty, or how the child ended without a text: "it was ended by Segmentation fault"
};

/// Calls `work` in a copy of this process (fork) and gives back its text, for libraries that may crash, run on or take
/// all memory on what users give them. The copy prints nothing, leaves no core file and ends when this process ends.
/// Other threads do not exist in it: what they may hold locked, `work` must not need. The caller therefore holds such
/// locks itself, as a GmshSession does for gmsh. Throws RunError where no process can be started.
ChildWork in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

}  // namespace parison::core
