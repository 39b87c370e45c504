// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "forming/scene/scene.hpp"
#include "tools/workbench/answers/workbench_state.hpp"
#include "tools/workbench/edit/open_case.hpp"

namespace parison::tools {
namespace {

/// The sentence with which the reader refuses a case; empty where it does not.
std::string refusal_of(const std::string& file) {
  try {
    forming::read_scene(file, "draft");
    return "";
  } catch (const core::CaseError& error) {
    return error.what();
  }
}

/// The words of a sentence that is about a probe and ends with a list of what is allowed in its place; none where it
/// lists something else, as ranges or units.
std::vector<std::string> allowed_words(const std::string& sentence, const std::string& probe) {
  static const std::regex list("allowed are ((?:[A-Za-z_][A-Za-z0-9_-]*, )*[A-Za-z_][A-Za-z0-9_-]*)$"), comma(", ");
  std::smatch found;
  if (sentence.find(probe) == sentence.npos || !std::regex_search(sentence, found, list)) return {};
  const std::string words = found[1];
  return {std::sregex_token_iterator(words.begin(), words.end(), comma, -1), std::sregex_token_iterator()};
}

}  // namespace

void add_allowed(WorkbenchState& state, const Asked& asked, core::JsonWriter& json) {
  const std::string name = asked.text_of("case"), probe = asked.text_of("probe");
  json.open_list("allowed");
  if (!is_bundled(name)) {  // nothing is written beside those
    const std::lock_guard<std::mutex> lock(state.reading);
    const PassingCopy copy(state.open(name).file(), asked.text_of("text"));
    for (const std::string& word : allowed_words(refusal_of(copy.file()), probe)) json.add("", word);
  }
  json.close();
}

}  // namespace parison::tools
