#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"
#include "tools/commands/commands.hpp"

namespace parison::tools {

inline constexpr const char* what_a_case_is =
    "folder that holds a case.toml, a case file, or the name of a bundled case";

/// The case that is given on the command line (find_case). A folder of results in its place is refused with what can be
/// given instead.
std::string case_of(const std::string& given);

/// Adds a command whose options fill a request, with what is to be done with that.
template <typename Request>
CLI::App* add_command(CLI::App& app, const char* name, const char* what, Command& chosen,
                      const std::shared_ptr<Request>& request, int (*work)(const Request&)) {
  auto* command = app.add_subcommand(name, what);
  command->callback([&chosen, request, work] { chosen = [request, work] { return work(*request); }; });
  return command;
}

/// Refuses two --set of a command line, of which the last would count alone; `before` has what the case has already.
void require_keys_once(const std::string& case_path, const std::vector<std::string>& before,
                       const std::vector<std::string>& assignments);

/// The work of a command, each --set of which counts.
template <typename Request, int (*work)(const Request&)>
int with_keys_once(const Request& request) {
  require_keys_once(request.case_path, {}, request.overrides);
  return work(request);
}

/// Each --set of a command line belongs to the --variant before it.
struct GivenSets {
  std::vector<std::string> before;  ///< all variants
  std::vector<forming::WhatIfVariant> variants;
};
GivenSets given_sets(const CLI::App& command, const CLI::Option* variant, const CLI::Option* set);

/// Adds the commands that run one case, and those that make many runs, with their options.
void add_run_commands(CLI::App& app, Command& chosen);
void add_study_commands(CLI::App& app, Command& chosen);

}  // namespace parison::tools
