#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

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

}  // namespace parison::forming
