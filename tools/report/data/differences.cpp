// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/differences.hpp"

#include <exception>
#include <nlohmann/json.hpp>
#include <sstream>

#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/same_case.hpp"

namespace parison::tools {
namespace {

using Json = nlohmann::ordered_json;

/// A text of several indented lines as one line.
std::string in_one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line, word;
  while (words >> word) line += (line.empty() ? "" : " ") + word;
  return line;
}

Json rows_of(const forming::RunComparison& result) {
  Json rows = Json::array();
  for (const forming::Difference& difference : result.quantities) {
    const forming::ShownDifference row = forming::shown(difference);
    rows.push_back({{"quantity", row.label},
                    {"base", row.base},
                    {"other", row.other},
                    {"difference", row.difference},
                    {"bar", row.bar},
                    {"model", row.model},
                    {"unit", row.unit},
                    {"verdict", row.verdict}});
  }
  return rows;
}

/// A folder that is damaged, still written or of another case costs its table and not the page.
Json against(const std::string& base, const std::string& folder) {
  try {
    const forming::Comparison comparison = forming::compare_folders(base, {folder});
    const forming::ComparedRun& other = comparison.others.front();
    if (!other.result) return {{"reason", "no results: " + other.reason}};
    return {{"settings", forming::settings_line(other.settings)},
            {"rows", rows_of(*other.result)},
            {"bars", in_one_line(forming::bars_line(*other.result, comparison.base, other.run) +
                                 forming::models_line(*other.result, comparison.base, other.run))}};
  } catch (const std::exception& error) {
    return {{"reason", error.what()}};
  }
}

}  // namespace

Json differences_of(const std::vector<std::string>& folders, const std::vector<std::string>& names,
                    const std::vector<forming::FailedVariant>& failed) {
  if (folders.size() + failed.size() < 2) return {};
  Json others = Json::array();
  for (std::size_t i = 1; i < folders.size(); ++i) {
    Json other = against(folders.front(), folders[i]);
    other["run"] = names[i];
    others.push_back(std::move(other));
  }
  for (const forming::FailedVariant& one : failed)
    others.push_back({{"run", one.name}, {"reason", "no results: " + one.reason}});
  return {{"base", names.front()}, {"others", std::move(others)}};
}

}  // namespace parison::tools
