#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/scene/scene.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::forming {

/// Finds the accuracy at which a difference of a given size is larger than its error bar, from the bars of coarser
/// rounds.
class ResolutionControl {
 public:
  /// "0.02mm" of the thinnest wall, or "heat_blank=50 J" of another quantity, of those that runs may have. Throws
  /// core::CaseError where the quantity is none of them, the size is none in its unit, or no bar can be so small:
  /// least_bar of the scale that is known before the runs.
  ResolutionControl(const std::string& wanted, const std::vector<Quantity>& possible);

  /// Of the next round.
  std::string accuracy() const;
  /// The comparison of a round, and its CPU time, s. Throws core::CaseError where its base does not have the quantity.
  void add(const Comparison& comparison, double cpu_seconds = std::numeric_limits<double>::quiet_NaN());
  /// Whether the bars of all variants are small enough, and each has one.
  bool reached() const;
  /// Whether there is nothing more to run: reached, or out of reach, as where a variant stops again and again, the size
  /// is below what any bar can be, the bars do not shrink, or what they shrink to would cost too much.
  bool finished() const;

  const std::string& quantity() const { return quantity_; }
  std::string label() const;  ///< of the quantity, for people
  const std::string& unit() const { return unit_; }
  double target() const { return target_; }  ///< in that unit
  double bar() const { return bar_; }        ///< the largest of the last round
  int rounds() const { return rounds_; }
  double expected_bar() const;  ///< the largest of the next round; NaN where it is not known
  double expected_cpu() const;  ///< of the next round, s; NaN where it is not known
  /// Why the last two rounds say that finer ones will not reach the size; empty where they do not.
  std::string gives_up() const { return gives_up_; }
  /// The smallest size that can be asked for, where more than the size that is; as a sentence with that size, else
  /// empty.
  std::string too_small() const;
  /// The variants that have no bar in the last round.
  const std::vector<std::string>& without_bar() const { return without_bar_; }

 private:
  std::string wanted_, quantity_, unit_;
  double factor_, next_factor_;  ///< edges and steps of the last round and the next, in units of those of draft
  double target_, bar_;
  double least_ = 0;  ///< that a bar can be, as far as is known
  std::vector<std::string> without_bar_;
  bool out_of_reach_ = false;
  double order_ = 1;         ///< with which the bars went with edges and steps in the last two rounds
  double cost_order_ = 2.5;  ///< with which the CPU time went with one over them
  double cpu_;               ///< of the last round, s
  std::string gives_up_;

  void learn_orders(double bar_before, double factor_before, double cpu_before);
  void judge_effort(double bar_before, double factor_before);
  int rounds_ = 0;
};

/// A change of a case whose effect is asked for.
struct WhatIfVariant {
  std::string name;  ///< also of its folder
  std::vector<std::string> overrides;
};

/// A variant of one assignment, named by it.
WhatIfVariant variant_of(const std::string& assignment);

/// A case at an accuracy, and changes of it.
struct WhatIf {
  std::string case_path, accuracy, directory;
  std::vector<std::string> overrides;  ///< of all runs, the base too
  std::vector<WhatIfVariant> variants;
  bool twice = false;  ///< each difference is the mean of two, the second from tools that are a little warmer
  std::string base_results = {};  ///< folder of a finished run that is the base; empty: the base is run
};

/// The folder of the base below that of a what-if, and its name in tables.
inline constexpr const char* base_name = "base";

/// A run that begins with what another one had at the end of a stage.
struct BranchPoint {
  std::string directory;  ///< of that run
  std::string stage;
  bool warmer_tools = false;  ///< a twin: its tools are warmer by twin_warmer
};

/// A run of a what-if.
struct PlannedRun {
  std::string label, directory, accuracy;
  std::vector<std::string> overrides;  ///< with those of all runs
  std::optional<BranchPoint> branch;   ///< none: from the start
  std::string inside;                  ///< folder of the run whose own it lies in; empty for none
  std::string copy_of = {};            ///< folder of the same run, finished elsewhere; empty for none
};

/// The last stage after which a changed case may take up a run of another case: all that the run has used up to its end
/// is the same. None where that is not so of the first stage, or no stage follows.
std::optional<std::string> last_common_stage(const Scene& base, const Scene& changed);

/// The runs of a what-if, those that others need before them: base and variants, a coarser run of each for the error
/// bars, twins of the coarser runs of the base. A variant that changes nothing has none. Throws core::CaseError where
/// no variant is left, and where the base or a variant is refused, with the name of the variant before the sentence:
/// all is read, and the first stage tried, before anything runs.
std::vector<PlannedRun> plan_runs(const WhatIf& what_if);

/// The coarser runs for the error bars of differences between runs of a case that have come to their end in these
/// folders, and twins of those of the first, which the others are compared with.
std::vector<PlannedRun> plan_partner_runs(const std::string& case_path, const std::vector<std::string>& folders);

/// What a variant changes against the base, value by value; the second leaves out values that are only written
/// otherwise.
std::vector<CaseDifference> settings_of(const WhatIf& what_if, const WhatIfVariant& variant);
std::vector<CaseDifference> changed_settings(const WhatIf& what_if, const WhatIfVariant& variant);

/// A variant in a sentence: its name and what it assigns.
std::string variant_text(const WhatIfVariant& variant);

/// A sentence for each tool that a variant starts at one temperature, where the base has a field that an earlier run or
/// settled production has left in it.
std::vector<std::string> settled_replaced(const WhatIf& what_if, const WhatIfVariant& variant);

/// Where all values of a variant are those that the base has, maybe in another unit, a sentence that says so; else
/// empty.
std::string nothing_changed(const WhatIf& what_if, const WhatIfVariant& variant);

/// Whether a file or folder of a result folder is that of another run: a coarser one or a twin.
bool is_run_folder(const std::string& name);

/// Makes the folder of a run of a case that begins at a branch point: a checkpoint to resume from, and the files up to
/// there.
void make_branch(const PlannedRun& run, const std::string& case_path);

}  // namespace parison::forming
