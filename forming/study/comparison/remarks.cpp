// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "forming/report/checks/check.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::forming {
namespace {

constexpr std::size_t longest_warning = 140;  ///< characters that are shown of one

/// Items of a list of the summary; none where it is missing.
std::vector<core::JsonValue> items_of(const core::JsonValue& summary, const char* list) {
  const core::JsonValue* found = summary.find(list);
  return found ? found->items : std::vector<core::JsonValue>{};
}

Remark flag_of(const core::JsonValue& flag) {
  const std::string tool = flag.text_of("tool"), unit = flag.text_of("unit");
  const std::string name = flag.text_of("name") + (tool.empty() ? "" : " of " + tool);
  return {Remark::Kind::flag, name,
          fmt::format("{}: {:.3g} {}, limit {:.3g} {}", name, flag.number_of("value"), unit, flag.number_of("limit"),
                      unit)};
}

/// Without numbers two runs say the same where only these differ. The first sentence is shown, or its beginning.
Remark warning_of(const std::string& sentence) {
  std::string name;
  for (const char c : sentence)
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) name += c;
  std::string text = sentence.substr(0, sentence.find("; "));
  if (text.size() > longest_warning) text = text.substr(0, text.rfind(' ', longest_warning)) + " ...";
  return {Remark::Kind::warning, name, text};
}

/// Checks say what is beyond their limits, far beyond where the results cannot be trusted.
Remark check_of(const core::JsonValue& check) {
  const bool is_severe = check.text_of("verdict") == name_of(Verdict::not_trustworthy);
  const std::string name = check.text_of("name"), unit = check.text_of("unit");
  return {Remark::Kind::failed_check, name,
          value_and_limit({name, check.number_of("value"), check.number_of("limit"), no_limit, unit.c_str(), ""}) +
              (is_severe ? ": not trustworthy" : "")};
}

/// Whether a remark of one run is worth a line beside those of another: a failed check always.
bool is_shown(const Remark& remark, const std::vector<Remark>& beside) {
  if (remark.kind == Remark::Kind::failed_check) return true;
  const Remark* same = same_remark(beside, remark);
  return !same || (remark.kind == Remark::Kind::flag && same->text != remark.text);
}

/// The runs that have come to their end, by the name that they have in the tables.
std::vector<std::pair<std::string, const FinishedRun*>> runs_of(const Comparison& comparison) {
  std::vector<std::pair<std::string, const FinishedRun*>> runs;
  for (const ComparedRun& other : comparison.others)
    if (other.result) runs.emplace_back(other.label, &other.run);
  return runs;
}

}  // namespace

const char* name_of(Remark::Kind kind) {
  constexpr std::array names{"flag", "warning", "failed check"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<Remark> read_remarks(const core::JsonValue& summary) {
  std::vector<Remark> remarks;
  for (const core::JsonValue& flag : items_of(summary, "flags")) remarks.push_back(flag_of(flag));
  for (const core::JsonValue& warning : items_of(summary, "warnings")) remarks.push_back(warning_of(warning.text));
  for (const core::JsonValue& check : items_of(summary, "checks"))
    if (check.text_of("verdict") != name_of(Verdict::inside)) remarks.push_back(check_of(check));
  return remarks;
}

const Remark* same_remark(const std::vector<Remark>& remarks, const Remark& remark) {
  for (const Remark& one : remarks)
    if (one.kind == remark.kind && one.name == remark.name) return &one;
  return nullptr;
}

std::string remark_lines(const Comparison& comparison) {
  const auto runs = runs_of(comparison);
  std::size_t width = comparison.base.name.size();
  for (const auto& run : runs) width = std::max(width, run.first.size());
  std::string lines;
  const auto add = [&](const std::string& run, const std::string& what) {
    lines += fmt::format("  {:<{}}  {}\n", run, width, what);
  };
  for (const Remark& remark : comparison.base.remarks)
    if (std::any_of(runs.begin(), runs.end(), [&](const auto& run) { return is_shown(remark, run.second->remarks); }))
      add(comparison.base.name, fmt::format("{} {}", name_of(remark.kind), remark.text));
  for (const auto& [label, run] : runs) {
    for (const Remark& remark : run->remarks)
      if (is_shown(remark, comparison.base.remarks))
        add(label, fmt::format("{} {}", name_of(remark.kind), remark.text));
    for (const Remark& remark : comparison.base.remarks)
      if (!same_remark(run->remarks, remark))
        add(label, fmt::format("without the {} of {}: {}", name_of(remark.kind), comparison.base.name, remark.text));
  }
  if (lines.empty()) return "\nflags and warnings: the same in all runs; no check failed\n";
  return "\nflags and warnings that differ between the runs, and failed checks:\n" + lines;
}

}  // namespace parison::forming
