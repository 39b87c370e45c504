#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace parison::forming {

/// How a watched number stands to its limits, and the names of that.
enum class Verdict { inside, beyond, not_trustworthy };
const char* name_of(Verdict verdict);

/// What a finer accuracy does to a number: nothing; makes it smaller; makes it smaller, and it is about the share by
/// which results are wrong.
enum class CheckKind { scene, resolution, error };

/// A number that tells how far a result can be trusted.
struct Check {
  std::string name;
  double value;           ///< 0 where all is well; larger is worse
  double limit;           ///< up to here nothing is said
  double severe_limit;    ///< beyond it the results cannot be trusted; infinity: never for this alone
  const char* unit = "";  ///< in which both are shown: "%", "mm" or none
  std::string sentence;   ///< what the number means and what to do
  CheckKind kind = CheckKind::scene;
  Verdict verdict() const;
};
using Checks = std::vector<Check>;
inline constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Whether a number is further from what can be trusted than another: greater, or no number.
inline bool is_worse(double number, double other) {
  return number > other || (std::isnan(number) && !std::isnan(other));
}

/// Whether none is beyond its severe limit.
bool trustworthy(const Checks& checks);

/// "all 14 checks inside their limits", or which are not.
std::string verdict_sentence(const Checks& checks);

/// "work_balance is 2.1 %, the limit is 1 %".
std::string value_and_limit(const Check& check);

/// Those beyond their limit, a sentence each with name, number and limit.
std::vector<std::string> complaints(const Checks& checks);

}  // namespace parison::forming
