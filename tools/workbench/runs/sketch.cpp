// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/runs/sketch.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "tools/program/child_process.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/workbench/folder/left_files.hpp"
#include "tools/workbench/runs/wall_band.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

}  // namespace

Sketch::Sketch() : folder_(passing_folder()) {}

Sketch::~Sketch() {
  end_child();
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Sketch::end_child() {
  if (child_ == 0) return;
  kill(child_, SIGKILL);
  waitpid(child_, nullptr, 0);
  child_ = 0;
}

void Sketch::start(const std::string& case_file, long version) {
  end_child();
  std::error_code ignored;
  fs::remove_all(fs::path(folder_) / std::to_string(count_), ignored);
  ++count_;
  version_ = version;
  case_file_ = case_file;
  child_ = start_self({"run", case_file, "--accuracy", "draft coarser 2", "--output", output(), "--set",
                       "output.interval=\"1 h\"", "--later-counts", "--keep-going"},
                      output() + ".log");
}

std::string Sketch::output() const {
  return folder_ + "/" + std::to_string(count_);
}

std::string Sketch::ended_of(const std::string& case_file) {
  if (child_ != 0 && has_ended(child_)) child_ = 0;
  return child_ == 0 && case_file == case_file_ ? output() : "";
}

void Sketch::add_state(const std::string& wanted_file, core::JsonWriter& json) {
  if (child_ != 0 && has_ended(child_)) child_ = 0;
  json.add("version", version_);
  json.add("running", child_ != 0);
  if (child_ != 0 || count_ == 0) return;
  const auto summary = core::read_json_file(output() + "/summary.json");
  if (summary && summary->flag_of("completed")) {
    add_finished_wall(output(), wanted_file, json);
  } else {
    const std::string log = fs::exists(output() + ".log") ? core::read_text(output() + ".log") : "";
    const auto at = log.find("parison: ");
    json.add("problem", summary ? summary->text_of("reason") : at == log.npos ? log : log.substr(at + 9));
  }
}

void add_finished_wall(const std::string& folder, const std::string& wanted_file, core::JsonWriter& json) {
  const ResultTable contour = read_table(folder + "/contour.csv");
  const auto *loop = contour.column("loop"), *r = contour.column("r_mm"), *z = contour.column("z_mm");
  if (!loop || !r || !z) return;
  json.open_list("outlines_mm");
  for (std::size_t i = 0; i < r->size(); ++i) {
    if (i == 0 || (*loop)[i] != (*loop)[i - 1]) {
      if (i > 0) json.close();
      json.open_list("");
    }
    json.add("", (*r)[i]);
    json.add("", (*z)[i]);
  }
  if (!r->empty()) json.close();
  json.close();
  const auto summary = core::read_json_file(folder + "/summary.json");
  const auto* quantities = summary ? summary->find("quantities") : nullptr;
  for (const char* name : {"thickness_min", "thickness_mean"})
    if (const auto* one = quantities ? quantities->find(name) : nullptr)
      json.add(std::string(name) + "_mm", one->number_of("value"));
  add_wall_band(folder, wanted_file, json);
}

}  // namespace parison::tools
