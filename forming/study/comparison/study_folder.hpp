#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"

namespace parison::forming {

/// What a search for settled production has left in its folder, as a comparison sees it.
struct CycleResult {
  std::string reason;                   ///< why there is no settled container; empty where there is
  std::vector<CaseDifference> changes;  ///< in which its case differs from that of the base
  std::string not_possible;             ///< why no machine can have such tools; empty where one can
};

/// Reads cycle.json of the folder of a cycle, or of a variant of one; nothing where there is none.
std::optional<CycleResult> read_cycle_result(const std::string& folder);

/// A variant of a cycle whose production did not settle.
struct FailedVariant {
  std::string name;
  std::vector<CaseDifference> settings;  ///< in which it differs from the base
  std::string reason;
};

/// The folder of a what-if or a cycle, by what lies in it: the result folders below that its table compares, the base
/// first.
struct StudyFolder {
  enum class Kind { none, what_if, cycle };
  Kind kind = Kind::none;
  std::vector<std::string> runs = {};
  std::vector<FailedVariant> failed = {};  ///< rows of its table without a run in `runs`
  std::string unfinished = {};             ///< folder of a finer round that has not come to its end; empty for none

  explicit operator bool() const { return kind != Kind::none; }
};

/// Of a what-if that looked for an accuracy the runs at the finest one at which all have come to their end; of a cycle
/// the container of the first gob and the settled one, or with variants the settled ones. Those that have begun count.
StudyFolder study_folder(const std::string& folder);

/// "is the folder of a what-if", or of a cycle.
std::string study_text(const StudyFolder& study);

/// Where a folder that was given as a case is one of results and holds no case, a sentence that says what can be given
/// in its place; else empty.
std::string results_as_case(const std::string& folder);

}  // namespace parison::forming
