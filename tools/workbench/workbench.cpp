// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/workbench.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <thread>

#include "core/case/case_error.hpp"
#include "forming/run/stage.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/program/child_process.hpp"
#include "tools/server/page_server.hpp"
#include "tools/workbench/answers/page_answers.hpp"
#include "tools/workbench/folder/recent_folders.hpp"

namespace parison::tools {

namespace {

/// The first check takes half a second more, in which libraries are loaded: before anybody waits for it.
void first_check(WorkbenchState& state) {
  const std::lock_guard<std::mutex> lock(state.reading);
  try {
    forming::first_stage_failure(forming::read_scene(find_case("vial"), "draft"));
  } catch (const core::CaseError&) {  // the bundled cases are not there
  }
}

}  // namespace

int workbench(const WorkbenchRequest& request) {
  WorkbenchState state(request.folder);
  PageService service;
  service.option = "workbench";
  service.token = random_token();
  service.largest_body = 100'000'000;
  service.answer = [&](const PageRequest& asked) { return page_answer(state, asked); };
  service.takes_long = takes_long;
  std::thread warm([&] { first_check(state); });
  serve(service, request.port, [&](const std::string& address) {
    remember_folder(state.folder.path());
    fmt::print("{} at {} on this machine only, until Ctrl-C\n", state.folder.path(), address);
    std::fflush(stdout);
    if (!request.no_browser) open_in_browser(address);
  });
  warm.join();
  return 0;
}

}  // namespace parison::tools
