// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/answers/page_answers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/workbench/answers/export_answer.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* policy =
    "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; connect-src 'self'; img-src 'self' "
    "data:; "
    "frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const std::string page_begin = "page/", picture_begin = "bundled/", result_begin = "result/", export_begin = "export/",
                  api_begin = "api/";

bool begins(const std::string& text, const std::string& begin) {
  return text.compare(0, begin.size(), begin) == 0;
}

/// The type of a file by its ending; empty where such files are not given out.
std::string type_of(const fs::path& file) {
  const std::map<std::string, std::string> types{{".html", "text/html; charset=utf-8"},
                                                 {".css", "text/css; charset=utf-8"},
                                                 {".js", "text/javascript; charset=utf-8"},
                                                 {".png", "image/png"}};
  const auto found = types.find(file.extension().string());
  return found == types.end() ? "" : found->second;
}

PageAnswer file_answer(const fs::path& folder, const std::string& name) {
  const fs::path file = folder / name;
  if (folder.empty() || name.find("..") != name.npos || name.find('\0') != name.npos || fs::path(name).is_absolute() ||
      type_of(file).empty() || !fs::is_regular_file(file))
    return refusal(404, "no such file");
  PageAnswer answer;
  answer.type = type_of(file);
  answer.body = core::read_text(file.string());
  answer.policy = policy;
  return answer;
}

PageAnswer report_answer(WorkbenchState& state, const std::string& rest) {
  const auto slash = rest.rfind('/');
  if (slash == rest.npos) return refusal(404, "no such results");
  const std::lock_guard<std::mutex> lock(state.reading);
  const fs::path folder = state.folder.existing(rest.substr(0, slash));
  if (!is_result_folder(folder.string()) && slash + 1 == rest.size() && fs::exists(folder / "report.html")) {
    PageAnswer answer = file_answer(folder, "report.html");
    answer.policy = report_policy("'self'");
    return answer;
  }
  return state.watched(rest.substr(0, slash)).answer(rest.substr(slash + 1), "'self'");
}

using Answer = void (*)(WorkbenchState&, const Asked&, core::JsonWriter&);

const std::map<std::string, Answer>& answers() {
  static const std::map<std::string, Answer> all{
      {"start", add_start},         {"case", add_case},       {"news", add_news},       {"set", change_values},
      {"text", change_text},        {"undo", undo_change},    {"redo", redo_change},    {"check", add_check},
      {"handles", add_handles},     {"new", make_case},       {"run", start_run},       {"what-if", start_what_if},
      {"stop", stop_run},           {"resume", resume_run},   {"sketch", start_sketch}, {"outline", add_outline},
      {"drawings", add_drawings},   {"drawing", add_drawing}, {"results", add_results}, {"open", open_recent},
      {"wanted", take_wanted_wall}, {"allowed", add_allowed}, {"search", start_search}};
  return all;
}

/// Whether brackets stand deeper in each other than any question has them: reading those takes stack for each.
bool is_too_deep(const std::string& text) {
  constexpr int deepest = 16;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size() && depth <= deepest; ++i) {
    if (quoted && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      quoted = !quoted;
    else if (!quoted)
      depth += (text[i] == '[' || text[i] == '{') - (text[i] == ']' || text[i] == '}');
  }
  return depth > deepest;
}

PageAnswer api_answer(WorkbenchState& state, const std::string& name, const std::string& body) {
  const auto found = answers().find(name);
  if (found == answers().end()) return refusal(404, "no such question");
  if (is_too_deep(body)) return refusal(400, "values within each other were found, deeper than 16 levels");
  core::JsonWriter json;
  try {
    found->second(state, core::read_json(body, "what the page sent"), json);
  } catch (const core::CaseError& error) {
    return refusal(422, error.what());
  } catch (const core::RunError& error) {
    return refusal(400, error.what());
  }
  PageAnswer answer;
  answer.body = json.finish();
  return answer;
}

}  // namespace

bool takes_long(const PageRequest& request) {
  return begins(request.target, result_begin) || begins(request.target, export_begin);
}

PageAnswer page_answer(WorkbenchState& state, const PageRequest& request) {
  const std::string& target = request.target;
  const auto rest = [&](const std::string& begin) { return target.substr(begin.size()); };
  try {
    if (request.posts)
      return begins(target, api_begin) ? api_answer(state, rest(api_begin), request.body)
                                       : refusal(404, "no such question");
    const fs::path page = shared_file("tools/workbench/page");
    if (target.empty()) return file_answer(page, "workbench.html");
    if (begins(target, page_begin)) return file_answer(page, rest(page_begin));
    if (begins(target, result_begin)) return report_answer(state, rest(result_begin));
    if (begins(target, export_begin)) return export_answer(state, rest(export_begin));
    for (const BundledCase& one : bundled_cases())
      if (target == picture_begin + one.name + ".png")
        return file_answer(fs::path(one.picture).parent_path(), fs::path(one.picture).filename().string());
  } catch (const core::CaseError& error) {
    return refusal(404, error.what());
  }
  return refusal(404, "no such address");
}

}  // namespace parison::tools
