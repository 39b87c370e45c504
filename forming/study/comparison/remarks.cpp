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

constexpr std::size_t least = 40;  ///< characters of a line, however far it is indented

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  const std::size_t longest = std::max(least, width - std::min(width, indent));
  std::string lines;
  std::size_t from = 0;
  while (text.size() - from > longest) {
    std::size_t end = text.rfind(' ', from + longest);
    if (end == text.npos || end <= from) end = text.find(' ', from + longest);  // a word longer than a line
    if (end == text.npos) break;
    lines += text.substr(from, end - from) + '\n' + std::string(indent, ' ');
    from = end + 1;
  }
  return lines + text.substr(from);
}

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

/// A run that has come to its end, by the name that it has in the tables.
struct NamedRun {
  std::string name;
  const std::vector<Remark>* remarks;
};

/// The base first.
std::vector<NamedRun> runs_of(const Comparison& comparison) {
  std::vector<NamedRun> runs{{comparison.base.name, &comparison.base.remarks}};
  for (const ComparedRun& other : comparison.others)
    if (other.result) runs.push_back({other.label, &other.run.remarks});
  return runs;
}

/// The runs that say a remark and those that do not.
struct Said {
  std::vector<std::string> by, not_by;
};

Said said_by(const std::vector<NamedRun>& runs, const Remark& remark) {
  Said said;
  for (const NamedRun& run : runs) (same_remark(*run.remarks, remark) ? said.by : said.not_by).push_back(run.name);
  return said;
}

std::string heading_of(const Said& said) {
  if (said.not_by.empty()) return "  in all runs";
  if (said.by.size() == 1) return fmt::format("  only in {}", said.by.front());
  return fmt::format("  in {}, not in {}", fmt::join(said.by, ", "), fmt::join(said.not_by, ", "));
}

/// A line, or one for each run where a flag or a check has other values in them. Warnings are told as the first has
/// them.
std::string lines_of(const std::vector<NamedRun>& runs, const Remark& remark) {
  std::vector<std::pair<std::string, std::string>> texts;
  bool differ = false;
  for (const NamedRun& run : runs)
    if (const Remark* same = same_remark(*run.remarks, remark)) {
      texts.emplace_back(run.name, same->text);
      differ = differ || (remark.kind != Remark::Kind::warning && same->text != remark.text);
    }
  const auto line = [&](const std::string& text) {
    return "    " + wrapped(fmt::format("{} {}", name_of(remark.kind), text), 6) + '\n';
  };
  if (!differ) return line(remark.text);
  std::string lines;
  for (const auto& [run, text] : texts) lines += line(fmt::format("{} ({})", text, run));
  return lines;
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
  std::vector<std::pair<std::string, std::string>> groups;  // heading and lines, in the order of their first remarks
  std::vector<Remark> known;
  for (const NamedRun& run : runs)
    for (const Remark& remark : *run.remarks) {
      if (same_remark(known, remark)) continue;
      known.push_back(remark);
      const std::string heading = heading_of(said_by(runs, remark));
      auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& one) { return one.first == heading; });
      if (group == groups.end()) group = groups.insert(groups.end(), {heading, ""});
      group->second += lines_of(runs, remark);
    }
  if (groups.empty()) return "\nflags and warnings: none in any run; no check failed\n";
  std::string text = "\nflags, warnings and failed checks:\n";
  for (const auto& [heading, lines] : groups) text += heading + '\n' + lines;
  return text;
}

}  // namespace parison::forming
