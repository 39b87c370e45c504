// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/checks/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace parison::forming {

namespace {

std::string number(const Check& check, double value) {
  const std::string unit = check.unit;
  if (unit == "%") return fmt::format("{:.2g} %", 100 * value);
  if (unit == "mm") return fmt::format("{:.2g} mm", 1e3 * value);
  return fmt::format("{:.3g}", value);
}

std::string names(const Checks& checks, Verdict verdict) {
  std::vector<std::string> found;
  for (const Check& check : checks)
    if (check.verdict() == verdict) found.push_back(check.name);
  return fmt::format("{}", fmt::join(found, ", "));
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr std::array all{"inside", "beyond", "not trustworthy"};
  return all[static_cast<std::size_t>(verdict)];
}

Verdict Check::verdict() const {
  // A value that is no number is beyond every limit.
  if (value <= limit) return Verdict::inside;
  return value <= severe_limit ? Verdict::beyond : Verdict::not_trustworthy;
}

bool trustworthy(const Checks& checks) {
  return std::none_of(checks.begin(), checks.end(),
                      [](const Check& check) { return check.verdict() == Verdict::not_trustworthy; });
}

std::string verdict_sentence(const Checks& checks) {
  const std::string beyond = names(checks, Verdict::beyond), severe = names(checks, Verdict::not_trustworthy);
  if (beyond.empty() && severe.empty()) return fmt::format("all {} checks inside their limits", checks.size());
  std::string sentence;
  if (!severe.empty()) sentence = fmt::format("not trustworthy: {} far beyond the limit", severe);
  if (!beyond.empty()) sentence += fmt::format("{}{} beyond the limit", severe.empty() ? "" : "; ", beyond);
  return fmt::format("{}; of {} checks", sentence, checks.size());
}

std::string value_and_limit(const Check& check) {
  return fmt::format("{} is {}, the limit is {}", check.name, number(check, check.value), number(check, check.limit));
}

std::vector<std::string> complaints(const Checks& checks) {
  std::vector<std::string> sentences;
  for (const Check& check : checks)
    if (check.verdict() != Verdict::inside) sentences.push_back(value_and_limit(check) + ": " + check.sentence);
  return sentences;
}

}  // namespace parison::forming
