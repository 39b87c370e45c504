// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/search/case/search_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/case/text/case_text.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/study/comparison/what_if/tool_overlap.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"
#include "forming/study/setting_error.hpp"

namespace parison::forming {

namespace {

/// A group of a DXF file: its code and its value.
std::string group(int code, const std::string& value) {
  return fmt::format("{:3}\n{}\n", code, value);
}

std::string number(int code, double value) {
  return group(code, fmt::format("{:.12g}", value));
}

std::string point(int code, const core::Point& at) {
  return number(code, 1e3 * at[0]) + number(code + 10, 1e3 * at[1]) + number(code + 20, 0);
}

/// Arcs of a drawing go counterclockwise.
std::string entity(const core::Segment& segment, const std::string& layer) {
  if (!segment.is_arc) return group(0, "LINE") + group(8, layer) + point(10, segment.start) + point(11, segment.end);
  const double from = std::min(segment.from, segment.to), to = std::max(segment.from, segment.to);
  return group(0, "ARC") + group(8, layer) + point(10, segment.centre) + number(40, 1e3 * segment.radius) +
         number(50, from / (M_PI / 180)) + number(51, to / (M_PI / 180));
}

bool same_outline(const core::Profile& a, const core::Profile& b) {
  if (a.segments.size() != b.segments.size()) return false;
  for (std::size_t i = 0; i < a.segments.size(); ++i) {
    const core::Segment &one = a.segments[i], &other = b.segments[i];
    if (one.is_arc != other.is_arc || one.start != other.start || one.end != other.end ||
        (one.is_arc && one.centre != other.centre))
      return false;
  }
  return true;
}

std::vector<std::string> write_drawings(const Scene& base, const Scene& found, const std::string& output) {
  std::vector<std::string> written;
  for (std::size_t i = 0; i < found.tools.size(); ++i) {
    const Tool& tool = found.tools[i];
    if (i >= base.tools.size() || same_outline(tool.profile, base.tools[i].profile)) continue;
    written.push_back(tool.name + ".dxf");
    core::replace_file(output + '/' + written.back(), dxf_text(tool.profile, tool.name));
  }
  return written;
}

}  // namespace

std::string dxf_text(const core::Profile& outline, const std::string& layer) {
  std::string text = group(0, "SECTION") + group(2, "HEADER") + group(9, "$ACADVER") + group(1, "AC1009") +
                     group(9, "$INSUNITS") + group(70, "4") + group(0, "ENDSEC") + group(0, "SECTION") +
                     group(2, "ENTITIES");
  for (const core::Segment& segment : outline.segments) text += entity(segment, layer);
  return text + group(0, "ENDSEC") + group(0, "EOF");
}

std::vector<std::string> write_case(const SearchCase& search, const Eigen::VectorXd& at, const std::string& output) {
  std::vector<std::string> overrides = search.overrides;
  for (std::string& setting : settings_at(search.variables, at)) overrides.push_back(std::move(setting));
  core::CaseFile file = core::read_case_file(search.case_path);
  // Of a bundled material or of the stages that `cooling` adds a part can be set where the whole is in the file.
  const bool adds_to_file = core::member(file.root, "cooling") ||
                            std::any_of(overrides.begin(), overrides.end(), [](const std::string& assignment) {
                              return assignment.rfind("material.", 0) == 0 || assignment.rfind("cooling", 0) == 0;
                            });
  if (adds_to_file)
    file = read_case(search.case_path, overrides);
  else
    for (const std::string& assignment : overrides) core::override_value(file, assignment);
  const Scene found = read_scene(search.case_path, search.accuracy, overrides);
  core::remove_own(case_copy_folder(output));
  copy_case(found, output);
  core::remove_own(case_copy_folder(output) + "/command.txt");
  const std::string path = case_copy_folder(output) + "/case.toml";
  core::replace_file(path, fmt::format("# {} with what a search of {} found.\n", found.name,
                                       std::filesystem::path(search.file).filename().string()) +
                               core::case_text(file.root));
  read_scene(path, search.accuracy);
  std::vector<std::string> written = write_drawings(read_scene(search.case_path, search.accuracy), found, output);
  written.insert(written.begin(), "case");
  return written;
}

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

std::optional<std::string> shared_stage(const SearchCase& search) {
  const auto at_bounds = [&](double (SearchVariable::*bound)() const) {
    std::vector<std::string> overrides = search.overrides;
    for (const SearchVariable& variable : search.variables)
      overrides.push_back(variable.key + '=' + variable.text((variable.*bound)()));
    return read_scene(search.case_path, search.accuracy, overrides);
  };
  try {
    return last_common_stage(at_bounds(&SearchVariable::low), at_bounds(&SearchVariable::high));
  } catch (const core::CaseError&) {
    return std::nullopt;  // refused there, so that nothing is known to be shared
  }
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
