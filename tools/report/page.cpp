// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/page.hpp"

#include <map>

#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {
namespace {

/// In the order in which one needs the other.
constexpr const char* scripts[] = {"elements.js", "colours.js",    "data.js",    "raster.js",  "section.js",
                                   "film.js",     "charts.js",     "figures.js", "machine.js", "tables.js",
                                   "search.js",   "production.js", "main.js"};

std::string page_file(const std::string& name) {
  const auto path = shared_file("tools/report/page/" + name);
  if (path.empty()) throw core::RunError("share/parison/tools/report/page/" + name + " is missing beside the program");
  return core::read_text(path.string());
}

std::string script_text() {
  std::string text;
  for (const char* name : scripts) text += page_file(name);
  return text;
}

}  // namespace

std::string html_text(const std::string& text) {
  const std::map<char, std::string> escapes{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string escaped;
  for (const char c : text) {
    const auto found = escapes.find(c);
    escaped += found == escapes.end() ? std::string(1, c) : found->second;
  }
  return escaped;
}

std::string page_text(const std::string& title, const std::string& data) {
  const std::map<std::string, std::string> parts{{"title", html_text(title)},
                                                 {"style", page_file("style.css")},
                                                 {"plot_style", page_file("uplot/uPlot.min.css")},
                                                 {"plot_script", page_file("uplot/uPlot.iife.min.js")},
                                                 {"script", script_text()},
                                                 {"data", data}};
  const std::string frame = page_file("page.html"), open = "{{", close = "}}";
  std::string text;
  std::size_t at = 0;
  for (std::size_t next; (next = frame.find(open, at)) != std::string::npos;) {
    const std::size_t end = frame.find(close, next);
    text += frame.substr(at, next - at) + parts.at(frame.substr(next + 2, end - next - 2));
    at = end + close.size();
  }
  return text + frame.substr(at);
}

}  // namespace parison::tools
