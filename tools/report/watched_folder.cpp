// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/watched_folder.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/report.hpp"

namespace parison::tools {
namespace fs = std::filesystem;

std::string report_policy(const std::string& ancestors) {
  return "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; connect-src 'self'; img-src "
         "data:; "
         "base-uri 'none'; form-action 'none'; frame-ancestors " +
         ancestors;
}

WatchedFolder::WatchedFolder(std::string path) : path_(std::move(path)), page_(page_text(path_, "null")) {}

PageAnswer WatchedFolder::answer(const std::string& target, const std::string& ancestors) {
  PageAnswer answer;
  answer.policy = report_policy(ancestors);
  if (target.empty()) {
    answer.type = "text/html; charset=utf-8";
    answer.body = page_;
  } else if (target == "stamp") {
    answer.body = '"' + stamp() + '"';
  } else if (target == "data") {
    answer.body = data();
  } else {
    return refusal(404, "no such address");
  }
  return answer;
}

std::string WatchedFolder::stamp() const {
  std::string text;
  for (const char* name : {"history.csv", "glass.pvd", "summary.json", "case/command.txt", "solid/history.csv",
                           "solid/glass.pvd", "solid/summary.json"}) {
    std::error_code missing;
    const fs::path file = fs::path(path_) / name;
    const auto size = fs::file_size(file, missing);
    const auto time = fs::last_write_time(file, missing);
    text += missing ? "-" : fmt::format("{} {},", size, time.time_since_epoch().count());
  }
  std::error_code unreadable;  // as of a link to itself
  const bool ended = fs::exists(fs::path(path_) / "summary.json", unreadable);
  return core::fingerprint_text(core::fingerprint(text + (ended || is_written(path_) ? "1" : "0")));
}

const std::string& WatchedFolder::data() {
  const std::string now = stamp();
  if (now == stamp_of_data_) return data_;
  try {
    data_ = is_result_folder(path_) ? report_data({path_}, true, cache_) : "null";
    stamp_of_data_ = now;
  } catch (const core::CaseError&) {  // the folder is being made or removed: the next look shows it
  } catch (const core::RunError&) {
  } catch (const fs::filesystem_error&) {
  }
  return data_;
}

}  // namespace parison::tools
