// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "core/case/case_error.hpp"
#include "core/case/case_file.hpp"
#include "tools/camera/camera.hpp"
#include "tools/commands/command_options.hpp"
#include "tools/commands/export_container.hpp"
#include "tools/materials/materials.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/report/report.hpp"
#include "tools/workbench/workbench.hpp"

namespace parison::tools {
namespace {

void add_export(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<ExportRequest>();
  auto* command = add_command(app, "export", "write the container of a result folder for CAD and structural programs",
                              chosen, request, export_container);
  command->add_option("results", request->results, "folder with the results of a run")->required();
  command->add_option("--step", request->step, "STEP file (.step): one solid of revolution, mm");
  command->add_option("--stl", request->stl, "STL file (.stl): its surface as triangles, mm");
  command->add_option("--shell", request->shell,
                      "input file for CalculiX or Abaqus (.inp): the middle of the wall as shells with its thickness");
}

void add_camera(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<CameraRequest>();
  auto* command = add_command(app, "camera", "show the hot container as an infrared camera beside it sees it", chosen,
                              request, camera);
  command->add_option("results", request->results, "folder with the results of a run")->required();
  command->add_option("--band", request->bands, "FROM TO: wavelengths; may be repeated [3 um 5 um, 0.9 um 1.1 um]")
      ->type_size(2)
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--time", request->time, "of the output, the nearest one [the end]");
  command->add_option("--surroundings", request->surroundings, "temperature behind the glass [ambient of the stage]");
  command->add_option("--pixel", request->pixel, "size of a pixel on the container")->capture_default_str();
  command->add_option("--output", request->output, "name of the files without ending [camera in the folder]");
}

int report_given(const LiveReportRequest& request) {
  return request.live ? watch(request) : report(request);
}

void add_report(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<LiveReportRequest>();
  auto* command = add_command(app, "report", "write one HTML page on the runs of some result folders, or show it live",
                              chosen, request, report_given);
  command
      ->add_option("results", request->folders,
                   "folders with the results of runs, shown over each other; of a what-if or a cycle its runs")
      ->required();
  auto* output =
      command->add_option("--output", request->output, "HTML file for the page [report.html in the first folder]");
  auto* live = command
                   ->add_flag("--live", request->live,
                              "show the page of one folder, also of one that is still to come, in a browser on this "
                              "machine while a run goes on")
                   ->excludes(output);
  command->add_option("--port", request->port, "port of the live page, or the next free one")
      ->capture_default_str()
      ->check(CLI::Range(1024, 65535))
      ->needs(live);
}

void add_workbench(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<WorkbenchRequest>();
  auto* command = add_command(app, "workbench", "work on the cases of a folder in the browser, on this machine alone",
                              chosen, request, workbench);
  command->add_option("folder", request->folder, "folder of cases and results")->capture_default_str();
  command->add_option("--port", request->port, "port of the page, or the next free one")
      ->capture_default_str()
      ->check(CLI::Range(1024, 65535));
  command->add_flag("--no-browser", request->no_browser, "only say the address");
}

void add_cases(CLI::App& app, Command& chosen) {
  app.add_subcommand("cases", "list the bundled cases")->callback([&chosen] {
    chosen = [] {
      fmt::print("{}", bundled_cases_table());
      return 0;
    };
  });
}

void add_materials(CLI::App& app, Command& chosen) {
  const auto request = std::make_shared<MaterialsRequest>();
  auto* command = add_command(app, "materials", "list the bundled materials, or show some", chosen, request, materials);
  command->add_option("name", request->names, "bundled materials to show with values and sources");
  command->add_option("--picture", request->picture, "SVG file for a plot of the viscosities");
}

}  // namespace

void add_commands(CLI::App& app, Command& chosen) {
  app.require_subcommand(1);
  add_run_commands(app, chosen);
  add_study_commands(app, chosen);
  add_export(app, chosen);
  add_camera(app, chosen);
  add_report(app, chosen);
  add_workbench(app, chosen);
  add_cases(app, chosen);
  add_materials(app, chosen);
}

void check_command(const CLI::App& app, int argc, const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  if (word.empty() || word[0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  for (const auto& [old, now] : {std::pair{"audit", "tradeoff CASE --parts"},
                                 {"fit-law", "calibrate --law DATA.csv"},
                                 {"watch", "report DIR --live"}})
    if (word == old) throw core::CaseError(fmt::format("parison: \"{}\" is now `parison {}`", word, now));
  throw core::CaseError(fmt::format("parison: no command \"{}\" was found{}, allowed are {}", word,
                                    core::did_you_mean(word, names), fmt::join(names, ", ")));
}

}  // namespace parison::tools
