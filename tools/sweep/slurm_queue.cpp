// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/slurm_queue.hpp"

#include <fmt/format.h>

#include <string_view>

#include "core/case/case_error.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "tools/program/child_process.hpp"

namespace parison::tools {
namespace {

constexpr int no_such_program = 127;

/// The last line of what Slurm said, without the name of its command.
std::string sentence(const std::string& text) {
  std::string_view last;
  core::Lines lines(text);
  for (std::string_view line; lines.next(line);)
    if (!core::trimmed(line).empty()) last = line;
  for (const std::string_view mark : {"error: ", "fatal: "})
    if (const auto at = last.rfind(mark); at != last.npos) last.remove_prefix(at + mark.size());
  return last.empty() ? "it said nothing" : std::string(last);
}

std::vector<std::string> sbatch(const SlurmJobs& jobs, const std::vector<std::string>& own) {
  std::vector<std::string> words{"sbatch"};
  words.insert(words.end(), jobs.options.begin(), jobs.options.end());
  words.insert(words.end(), {"--ntasks=1", "--cpus-per-task=1", "--no-requeue", "--job-name=" + jobs.name,
                             "--open-mode=append", "--output=" + jobs.messages});
  words.insert(words.end(), own.begin(), own.end());
  return words;
}

}  // namespace

std::string index_ranges(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size();) {
    std::size_t end = i;
    while (end + 1 < indices.size() && indices[end + 1] == indices[end] + 1) ++end;
    text += fmt::format("{}{}", text.empty() ? "" : ",", indices[i]);
    if (end > i) text += fmt::format("-{}", indices[end]);
    i = end + 1;
  }
  return text;
}

void require_slurm(SlurmJobs& jobs) {
  const ProgramOutput config = output_of_program({"scontrol", "show", "config"});
  if (config.code == no_such_program)
    throw core::CaseError(
        "--engine slurm: no Slurm was found here (scontrol), allowed is a machine that has it, or --engine local");
  if (config.code != 0)
    throw core::CaseError(fmt::format("--engine slurm: Slurm does not answer: {}", sentence(config.text)));
  core::Lines lines(config.text);
  for (std::string_view line; lines.next(line);)
    if (line.rfind("MaxArraySize", 0) == 0)
      if (const auto size = core::parse_number<std::size_t>(core::trimmed(line.substr(line.find('=') + 1)));
          size && *size > 1)
        jobs.array_size = *size;
  const ProgramOutput tried = output_of_program(sbatch(jobs, {"--test-only", "--wrap=true"}));
  if (tried.code != 0) throw core::CaseError(fmt::format("--engine slurm: Slurm refuses: {}", sentence(tried.text)));
}

std::optional<std::set<std::size_t>> rows_in_queue(const SlurmJobs& jobs) {
  const ProgramOutput queue =
      output_of_program({"squeue", "--noheader", "--array", "--name=" + jobs.name, "--format=%k|%K"});
  if (queue.code != 0) return std::nullopt;
  std::set<std::size_t> rows;
  core::Lines lines(queue.text);
  for (std::string_view line; lines.next(line);) {
    const auto bar = std::min(line.find('|'), line.size() - 1);
    const auto first = core::parse_number<std::size_t>(line.substr(0, bar)),
               index = core::parse_number<std::size_t>(core::trimmed(line.substr(bar + 1)));
    if (first && index) rows.insert(*first + *index);
  }
  return rows;
}

std::string submit(const SlurmJobs& jobs, std::vector<std::size_t>& rows) {
  while (!rows.empty()) {
    const std::size_t first = rows.front() / jobs.array_size * jobs.array_size;
    std::vector<std::size_t> indices;
    for (const std::size_t row : rows)
      if (row < first + jobs.array_size) indices.push_back(row - first);
    const std::string at_once = jobs.at_once > 0 ? fmt::format("%{}", jobs.at_once) : "";
    const ProgramOutput done =
        output_of_program(sbatch(jobs, {fmt::format("--array={}{}", index_ranges(indices), at_once),
                                        fmt::format("--comment={}", first), jobs.script, fmt::format("{}", first)}));
    if (done.code != 0) return sentence(done.text);
    rows.erase(rows.begin(), rows.begin() + static_cast<long>(indices.size()));
  }
  return {};
}

}  // namespace parison::tools
