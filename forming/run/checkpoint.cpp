// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/checkpoint.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/mesh_hdf5.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/run/resume/case_change.hpp"
#include "forming/run/resume/changed_tools.hpp"
#include "forming/solid/hand_over.hpp"
#include "forming/solid/visit_solid.hpp"
#include "forming/state/visit_state.hpp"

namespace parison::forming {
namespace {

using core::Hdf5Group;

constexpr std::int64_t format_version = 16;

std::vector<double> numbers_of(const std::vector<flow::SolidContact>& contact) {
  std::vector<double> numbers;
  for (const flow::SolidContact& point : contact)
    for (const double number : {static_cast<double>(point.tool), point.gap, point.pressure,
                                static_cast<double>(point.touches), static_cast<double>(point.released)})
      numbers.push_back(number);
  return numbers;
}

std::vector<flow::SolidContact> contact_of(const std::vector<double>& numbers) {
  std::vector<flow::SolidContact> contact;
  for (std::size_t i = 0; i + 5 <= numbers.size(); i += 5)
    contact.push_back(
        {static_cast<Index>(numbers[i]), numbers[i + 1], numbers[i + 2], numbers[i + 3] != 0, numbers[i + 4] != 0});
  return contact;
}

struct Writer {
  Hdf5Group group;
  void operator()(const char* name, double value) { group.write(name, value); }
  void operator()(const char* name, int value) { group.write(name, std::int64_t{value}); }
  void operator()(const char* name, long value) { group.write(name, std::int64_t{value}); }
  void operator()(const char* name, bool value) { group.write(name, std::int64_t{value}); }
  void operator()(const char* name, const std::string& value) { group.write(name, value); }
  void operator()(const char* name, const std::vector<double>& value) { group.write(name, value); }
  void operator()(const char* name, const Eigen::VectorXd& value) { group.write(name, value); }
  void operator()(const char* name, const std::vector<int>& value) { group.write(name, value); }
  void operator()(const char* name, const std::vector<Point>& value) { core::write_points(group, name, value); }
  void operator()(const char* name, const std::vector<core::Vector3>& value) {
    std::vector<double> numbers;
    for (const core::Vector3& at : value) numbers.insert(numbers.end(), at.begin(), at.end());
    group.write(name, numbers, 3);
  }
  void operator()(const char* name, const std::vector<flow::SolidContact>& value) {
    group.write(name, numbers_of(value), 5);
  }
  void operator()(const char* name, const core::Mesh& value) { core::write_mesh(group.create(name), value); }
  Writer part(const std::string& name) { return {group.create(name)}; }
};

struct Reader {
  Hdf5Group group;
  void operator()(const char* name, double& value) { value = group.read_double(name); }
  void operator()(const char* name, int& value) { value = static_cast<int>(group.read_integer(name)); }
  void operator()(const char* name, long& value) { value = static_cast<long>(group.read_integer(name)); }
  void operator()(const char* name, bool& value) { value = group.read_integer(name) != 0; }
  void operator()(const char* name, std::string& value) { value = group.read_string(name); }
  void operator()(const char* name, std::vector<double>& value) { value = group.read_doubles(name); }
  void operator()(const char* name, Eigen::VectorXd& value) { value = group.read_vector(name); }
  void operator()(const char* name, std::vector<int>& value) { value = group.read_integers(name); }
  void operator()(const char* name, std::vector<Point>& value) { value = core::read_points(group, name); }
  void operator()(const char* name, std::vector<core::Vector3>& value) {
    const std::vector<double> numbers = group.read_doubles(name);
    for (std::size_t n = 0; n < value.size(); ++n) value[n] = Eigen::Map<const core::Vector3>(&numbers.at(3 * n));
  }
  void operator()(const char* name, std::vector<flow::SolidContact>& value) {
    value = contact_of(group.read_doubles(name));
  }
  void operator()(const char* name, core::Mesh& value) { value = core::read_mesh(group.open(name)); }
  Reader part(const std::string& name) { return {group.open(name)}; }
};

/// The names of what it visits, in order.
struct Names {
  std::string& names;
  template <typename Value>
  void operator()(const char* name, const Value&) {
    names += fmt::format("{}\n", name);
  }
  Names part(const std::string& name) {
    names += name + '/';
    return *this;
  }
};

/// Hash of the list of all values of a state and of what a run has seen: another list is another layout of the file.
std::int64_t state_layout() {
  State state;
  state.tools.resize(1);
  std::string names;
  visit_state(Names{names}, state);
  SolidState solid;
  solid.tools.resize(1);
  visit_solid(Names{names}, solid);
  Diagnostics seen;
  resize(seen, state.tools.size());
  visit_diagnostics(Names{names}, seen);
  return static_cast<std::int64_t>(core::fingerprint(names));
}

template <typename Visitor, typename Filling>
void visit_filling(Visitor visit, Filling& filling) {
  visit("share", filling.share);
  visit("largest_gap", filling.largest_gap);
  visit("r", filling.at[0]);
  visit("z", filling.at[1]);
  visit("time", filling.time);
}

template <typename Visitor, typename Facts>
void visit_facts(Visitor visit, Facts& facts) {
  visit("wall_seconds", facts.wall_seconds);
  visit("cpu_seconds", facts.cpu_seconds);
  for (const char* part : timed_parts) visit(part, facts.timing[part]);
  visit_diagnostics(visit.part("diagnostics"), facts.diagnostics);
  visit_filling(visit.part("mould_filling"), facts.filling);
  visit("unfilled", facts.unfilled);
  for (std::size_t i = 0; i < facts.warnings.size(); ++i)
    visit(fmt::format("warning_{}", i).c_str(), facts.warnings[i]);
  for (std::size_t i = 0; i < facts.stages.size(); ++i) {
    auto& record = facts.stages[i];
    Visitor stage = visit.part(fmt::format("stage_{}", i));
    stage("name", record.name);
    stage("start", record.start);
    stage("end", record.end);
    stage("end_reason", record.end_reason);
    visit_work(stage.part("work"), record.work);
  }
}

template <typename Visitor, typename Files>
void visit_files(Visitor visit, Files& files) {
  visit("history_size", files.history_size);
  visit("tools_size", files.tools_size);
  visit("interface_size", files.interface_size);
  visit("solid_history_size", files.solid_history_size);
  visit("solid_output_times", files.solid_output_times);
  visit("stage_lowest", files.stage_lowest);
  visit("output_times", files.output_times);
}

void require_version(const std::string& path, const Hdf5Group& file) {
  const std::int64_t version = file.has("version") ? file.read_integer("version") : 0;
  if (version != format_version)
    throw core::CaseError(
        fmt::format("{}: a checkpoint of version {} was found, allowed is version {}", path, version, format_version));
  if (!file.has("layout") || file.read_integer("layout") != state_layout())
    throw core::CaseError(fmt::format(
        "{}: a checkpoint whose state holds other values was found, allowed is one of this version of the program",
        path));
}

std::vector<std::string> read_overrides(const Hdf5Group& file) {
  std::vector<std::string> overrides(static_cast<std::size_t>(file.read_integer("overrides")));
  for (std::size_t i = 0; i < overrides.size(); ++i) overrides[i] = file.read_string(fmt::format("override_{}", i));
  return overrides;
}

std::uint64_t fingerprint_in(const Hdf5Group& file) {
  return static_cast<std::uint64_t>(file.read_integer("fingerprint"));
}

/// The case as a run had it: the copy in its result folder, or the file it was read from where that has not changed
/// since; empty where neither has it as it was.
std::string case_as_it_was(const std::string& folder, const std::string& accuracy, const Hdf5Group& file) {
  for (const std::string& known : {case_copy_folder(folder), file.read_string("case_file")}) {
    const std::string text = std::filesystem::is_directory(known) ? known + "/case.toml" : known;
    if (!std::filesystem::exists(text)) continue;
    try {
      if (read_scene(known, accuracy, read_overrides(file)).fingerprint == fingerprint_in(file)) return known;
    } catch (const core::CaseError&) {  // it can no longer be read as it was
    }
  }
  return {};
}

/// The tools that are others since the case has changed; refused where the run has used what changed, or where nothing
/// has it as it was.
std::vector<Index> require_unused_change(const std::string& path, const Scene& scene, const Hdf5Group& file) {
  const auto stage = static_cast<Index>(file.open("state").read_integer("stage"));
  const std::string before =
      case_as_it_was(std::filesystem::path(path).parent_path().string(), scene.accuracy_name, file);
  if (before.empty())
    throw core::CaseError(fmt::format(
        "{}: a checkpoint of the case \"{}\" with another case file was found, allowed is one of \"{}\" as it is now",
        path, file.read_string("case"), scene.name));
  const std::string key = used_change(before, read_overrides(file), scene, stage);
  if (!key.empty())
    throw core::CaseError(
        fmt::format("{}: {} has changed, which the run up to this checkpoint has used; allowed are changes of output, "
                    "of the stages after \"{}\" and of tools that only those use",
                    path, key, scene.stages.at(stage).name));
  return changed_unused_tools(before, read_overrides(file), scene, stage);
}

/// Whether the copy of a result folder is the case of one of its checkpoints; nothing where it cannot be read.
std::optional<bool> is_of_a_checkpoint(const std::string& copy, const std::string& directory) {
  try {
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
      if (entry.path().extension() != ".h5" || !core::read_hdf5(entry.path()).problem.empty()) continue;
      const CaseOrigin origin = read_origin(entry.path());
      if (read_scene(copy, origin.accuracy, origin.overrides).fingerprint == origin.fingerprint) return true;
    }
    return false;
  } catch (const core::CaseError&) {
    return {};
  }
}

/// Refuses a checkpoint that the scene cannot go on from; the tools that are others in the scene.
std::vector<Index> require_match(const std::string& path, const Scene& scene, const Hdf5Group& file) {
  require_version(path, file);
  const std::string accuracy = file.read_string("accuracy");
  if (accuracy != scene.accuracy_name)
    throw core::CaseError(fmt::format("{}: a checkpoint at {} accuracy was found, allowed is one at {} accuracy", path,
                                      accuracy, scene.accuracy_name));
  if (fingerprint_in(file) != scene.fingerprint) return require_unused_change(path, scene, file);
  return {};
}

/// Glass in space: that of the hand-over, with the values of the checkpoint. Tools that are others are as they begin.
std::shared_ptr<SolidState> read_solid(Hdf5Group group, const Scene& scene, const State& state,
                                       const std::vector<Index>& changed_tools) {
  auto solid = std::make_shared<SolidState>(hand_over(scene, state, group.read_double("cell_size")));
  visit_solid(Reader{std::move(group)}, *solid, changed_tools);
  return solid;
}

void write_overrides(Hdf5Group& file, const std::vector<std::string>& overrides) {
  file.write("overrides", static_cast<std::int64_t>(overrides.size()));
  for (std::size_t i = 0; i < overrides.size(); ++i) file.write(fmt::format("override_{}", i), overrides[i]);
}

}  // namespace

void write_checkpoint(const std::string& directory, const Scene& scene, const Checkpoint& checkpoint) {
  core::write_hdf5(new_checkpoint(directory), [&](core::Hdf5Group& file) {
    file.write("version", format_version);
    file.write("layout", state_layout());
    file.write("case", scene.name);
    for (std::size_t i = 0; i < scene.tools.size(); ++i)
      file.write(fmt::format("tool_name_{}", i), scene.tools[i].name);
    file.write("case_file", std::filesystem::absolute(scene.file).string());
    file.write("accuracy", scene.accuracy_name);
    write_overrides(file, scene.overrides);
    file.write("fingerprint", static_cast<std::int64_t>(scene.fingerprint));
    file.write("stages_done", static_cast<std::int64_t>(checkpoint.outcome.facts.stages.size()));
    file.write("warnings", static_cast<std::int64_t>(checkpoint.outcome.facts.warnings.size()));
    RunFacts facts = checkpoint.outcome.facts;
    resize(facts.diagnostics, scene.tools.size());
    visit_facts(Writer{file.create("facts")}, facts);
    visit_files(Writer{file.create("files")}, checkpoint.files);
    visit_state(Writer{file.create("state")}, checkpoint.outcome.state);
    if (const SolidState* solid = checkpoint.outcome.solid.get()) {
      Hdf5Group group = file.create("solid");
      group.write("cell_size", solid->cell_size);
      visit_solid(Writer{std::move(group)}, *solid);
    }
  });
  put_in_place(directory);
}

Checkpoint read_checkpoint(const std::string& path, const Scene& scene) {
  const Hdf5Group file = core::open_hdf5(path);
  const std::vector<Index> changed_tools = require_match(path, scene, file);
  Checkpoint checkpoint;
  State& state = checkpoint.outcome.state;
  RunFacts& facts = checkpoint.outcome.facts;
  facts.stages.resize(static_cast<std::size_t>(file.read_integer("stages_done")));
  facts.warnings.resize(static_cast<std::size_t>(file.read_integer("warnings")));
  resize(facts.diagnostics, scene.tools.size());
  visit_facts(Reader{file.open("facts")}, facts);
  visit_files(Reader{file.open("files")}, checkpoint.files);
  state.tools.resize(scene.tools.size());
  visit_state(Reader{file.open("state")}, state);
  renew_unused_tools(scene, changed_tools, checkpoint.outcome);
  if (file.has("solid")) checkpoint.outcome.solid = read_solid(file.open("solid"), scene, state, changed_tools);
  return checkpoint;
}

CaseOrigin read_origin(const std::string& path) {
  const Hdf5Group file = core::open_hdf5(path);
  require_version(path, file);
  return {file.read_string("case_file"), file.read_string("accuracy"), read_overrides(file), fingerprint_in(file)};
}

void require_unchanged_copy(const std::string& directory, const Scene& scene) {
  const std::string folder = case_copy_folder(directory), copy = folder + "/case.toml";
  std::error_code error;
  if (!std::filesystem::is_regular_file(copy, error) || std::filesystem::equivalent(scene.file, copy, error)) return;
  const bool has_same_text = core::read_text(copy) == scene.files->front().content;
  if (is_of_a_checkpoint(folder, directory).value_or(has_same_text)) return;
  throw core::CaseError(
      fmt::format("{}: this copy of the case, or a drawing beside it, is no longer that of the run, which is taken up "
                  "with \"{}\"; allowed is a change there, or this copy itself with --case {}",
                  copy, scene.file, folder));
}

}  // namespace parison::forming
