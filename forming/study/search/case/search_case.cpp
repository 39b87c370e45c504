// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/case/search_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "forming/study/comparison/what_if/tool_overlap.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {

std::vector<std::string> settings_at(const std::vector<SearchVariable>& variables, const Eigen::VectorXd& at) {
  std::vector<std::string> settings;
  for (std::size_t i = 0; i < variables.size(); ++i)
    settings.push_back(variables[i].key + '=' + variables[i].text(at[Eigen::Index(i)]));
  return settings;
}

std::string refusal_of(const SearchCase& search, const Scene& base, const Eigen::VectorXd& at) {
  std::vector<std::string> overrides = search.overrides;
  for (std::string& setting : settings_at(search.variables, at)) overrides.push_back(std::move(setting));
  try {
    return new_tool_overlap(base, read_scene(search.case_path, search.accuracy, overrides));
  } catch (const core::CaseError& error) {
    return refusal_text(error);
  }
}

void check_corners(const SearchCase& search) {
  constexpr std::size_t most_corners = 1024, most_told = 8;
  const Scene base = read_scene(search.case_path, search.accuracy, search.overrides);
  const std::size_t count = search.variables.size();
  const std::size_t corners = count < 10 ? std::size_t(1) << count : most_corners;
  Eigen::VectorXd at(static_cast<Eigen::Index>(count));
  std::vector<std::string> refused;
  const auto check = [&](const char* where) {
    if (const std::string reason = refusal_of(search, base, at); !reason.empty())
      refused.push_back(
          fmt::format("at {} ({}): {}", where, fmt::join(settings_at(search.variables, at), ", "), reason));
  };
  for (std::size_t i = 0; i < count; ++i) at[Eigen::Index(i)] = search.variables[i].start;
  check("the start");
  for (std::size_t corner = 0; corner < corners; ++corner) {
    for (std::size_t i = 0; i < count; ++i) {
      const SearchVariable& variable = search.variables[i];
      at[Eigen::Index(i)] = corner >> (i % 10) & 1 ? variable.high() : variable.low();
    }
    check("a corner of the bounds");
  }
  if (refused.empty()) return;
  const std::size_t told = std::min(refused.size(), most_told);
  std::string text = fmt::format("{}: {}", search.file, fmt::join(refused.begin(), refused.begin() + told, "; "));
  if (told < refused.size()) text += fmt::format("; and at {} of {} corners more", refused.size() - told, corners);
  throw core::CaseError(text);
}

SweepPlan plan_runs(const SearchCase& search, const std::vector<Eigen::VectorXd>& places, const std::string& output) {
  Sweep sweep;
  sweep.file = search.file;
  sweep.name = "search";
  sweep.case_path = search.case_path;
  sweep.accuracy = search.accuracy;
  sweep.overrides = search.overrides;
  sweep.design = Design::list;
  sweep.runs = places.size();
  sweep.keep = search.keep;
  for (std::size_t i = 0; i < search.variables.size(); ++i) {
    SweepVariable variable{search.variables[i].key, {}, 0, 0, ""};
    for (const Eigen::VectorXd& at : places) variable.values.push_back(search.variables[i].text(at[Eigen::Index(i)]));
    sweep.variables.push_back(std::move(variable));
  }
  return plan_sweep(sweep, output);
}

}  // namespace parison::forming
