// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "core/case/case_error.hpp"
#include "tools/report/data/run_names.hpp"
#include "tools/report/report.hpp"
#include "tools/report/watched_folder.hpp"
#include "tools/server/page_server.hpp"

namespace parison::tools {

int watch(const LiveReportRequest& request) {
  if (request.folders.size() != 1)
    throw core::CaseError(fmt::format("--live: {} folders were found, allowed is one", request.folders.size()));
  const std::string& given = request.folders.front();
  std::error_code error;
  const auto found = std::filesystem::status(given, error).type();
  if (found != std::filesystem::file_type::not_found && found != std::filesystem::file_type::directory)
    throw core::CaseError(
        fmt::format("{}: is no folder, allowed is the result folder of a run, also one that is still to come", given));
  if (const std::string runs = run_folders_hint(given); !runs.empty())
    throw core::CaseError(fmt::format("{}: is the folder of several runs, allowed is that of one; {}", given, runs));
  WatchedFolder folder(given);
  PageService service;
  service.option = "--live";
  service.answer = [&](const PageRequest& asked) { return folder.answer(asked.target, "'none'"); };
  serve(service, request.port, [&](const std::string& address) {
    fmt::print("{} at {} on this machine only, until Ctrl-C\n", given, address);
    std::fflush(stdout);
  });
  return 0;
}

}  // namespace parison::tools
