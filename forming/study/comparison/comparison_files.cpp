// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/same_case.hpp"

namespace parison::forming {
namespace {

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.9g}", value) : "nan";
}

std::string quantities_csv(const Comparison& comparison) {
  std::string text = "run,settings,quantity,unit,base,other,difference,error_bar,scatter,verdict\n";
  for (const ComparedRun& other : comparison.others) {
    const std::string run = core::csv_text(other.label) + ',' + core::csv_text(settings_line(other.settings)) + ',';
    if (!other.result) {
      text += run + ",,nan,nan,nan,nan,nan," + core::csv_text("no results: " + other.reason) + '\n';
      continue;
    }
    for (const Difference& row : other.result->quantities)
      text += run + fmt::format("{},{},{},{},{},{},{},{}\n", row.name, core::csv_text(row.unit), csv_number(row.base),
                                csv_number(row.other), csv_number(row.difference), csv_number(row.bar),
                                csv_number(row.scatter), name_of(row.significance()));
  }
  return text;
}

/// Those of a run, with whether the base has the same.
void add_remarks(core::JsonWriter& json, const std::vector<Remark>& remarks, const std::vector<Remark>& base) {
  json.open_list("remarks");
  for (const Remark& remark : remarks) {
    json.open_object("");
    json.add("kind", name_of(remark.kind));
    json.add("name", remark.name);
    json.add("text", remark.text);
    json.add("in_base", same_remark(base, remark) != nullptr);
    json.close();
  }
  json.close();
}

void add_run(core::JsonWriter& json, const ComparedRun& other, const FinishedRun& base) {
  json.open_object("");
  json.add("run", other.label);
  json.add("folder", other.run.directory);
  json.open_list("settings");
  for (const CaseDifference& setting : other.settings) {
    json.open_object("");
    json.add("key", setting.key);
    json.add("base", setting.before);
    json.add("other", setting.now);
    json.close();
  }
  json.close();
  json.add("completed", other.result.has_value());
  json.add("reason", other.reason);
  if (other.result) {
    json.add("trustworthy", other.run.trustworthy);
    json.add("not_possible", other.run.not_possible);
    add_remarks(json, other.run.remarks, base.remarks);
    json.add("stages_in_common", static_cast<long>(other.result->in_common));
    json.add("twins", static_cast<long>(other.result->twins));
    json.add("pairs", static_cast<long>(other.result->pairs));
    json.add("second_pair_with", other.result->repeated);
    json.open_object("quantities");
    for (const Difference& row : other.result->quantities) {
      json.open_object(row.name);
      json.add("unit", row.unit);
      json.add("base", row.base);
      json.add("other", row.other);
      json.add("difference", row.difference);
      json.add("error_bar", row.bar);
      json.add("scatter", row.scatter);
      json.add("bars_added", row.added);
      json.add("model", row.model);
      json.add("scale", row.scale);
      json.add("verdict", name_of(row.significance()));
      json.close();
    }
    json.close();
  }
  json.close();
}

std::string comparison_json(const Comparison& comparison) {
  core::JsonWriter json;
  json.add("base", comparison.base.directory);
  json.add("accuracy", comparison.base.accuracy);
  json.add("trustworthy", comparison.base.trustworthy);
  json.add("not_possible", comparison.base.not_possible);
  add_remarks(json, comparison.base.remarks, comparison.base.remarks);
  json.open_list("runs");
  for (const ComparedRun& other : comparison.others) add_run(json, other, comparison.base);
  json.close();
  return json.finish();
}

bool has_profile(const ComparedRun& other) {
  return other.result && !other.result->profile.other.empty();
}

/// Empty without a wall of a run that is compared.
std::string profiles_csv(const Comparison& comparison) {
  const auto& base = comparison.base.quantities.profile;
  const bool is_compared = std::any_of(comparison.others.begin(), comparison.others.end(), has_profile);
  if (base.empty() || !is_compared) return "";
  std::string text = "share_of_arc,base_mm";
  std::vector<const ProfileComparison*> walls;
  for (const ComparedRun& other : comparison.others)
    if (has_profile(other)) {
      walls.push_back(&other.result->profile);
      text += ',' + core::csv_text(other.label + "_mm") + ',' + core::csv_text(other.label + "_difference_mm") + ',' +
              core::csv_text(other.label + "_error_bar_mm");
    }
  text += '\n';
  for (std::size_t i = 0; i < base.size(); ++i) {
    text += fmt::format("{:.4f},{}", double(i) / double(base.size() - 1), csv_number(base[i]));
    for (const ProfileComparison* wall : walls)
      text += fmt::format(",{},{},{}", csv_number(wall->other[i]), csv_number(wall->difference[i]),
                          csv_number(wall->bar[i]));
    text += '\n';
  }
  return text;
}

}  // namespace

std::set<std::string> comparison_files() {
  return {"comparison.csv", "comparison.json", "profiles.csv", "profiles.svg"};
}

std::string write_comparison(const Comparison& comparison, const std::string& folder) {
  const std::vector<std::pair<std::string, std::string>> files{{"comparison.csv", quantities_csv(comparison)},
                                                               {"comparison.json", comparison_json(comparison)},
                                                               {"profiles.csv", profiles_csv(comparison)},
                                                               {"profiles.svg", profile_plot(comparison)}};
  std::vector<std::string> written;
  for (const auto& [name, text] : files) {
    if (text.empty()) {
      core::remove_own(folder + '/' + name);  // of a comparison before
      continue;
    }
    core::replace_file(folder + '/' + name, text);
    written.push_back(name);
  }
  return fmt::format("{} in {}", fmt::join(written, ", "), folder);
}

}  // namespace parison::forming
