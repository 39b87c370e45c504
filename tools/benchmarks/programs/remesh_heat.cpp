// SPDX-License-Identifier: GPL-3.0-or-later
// remesh_heat CASE ACCURACY FOLDER [KEY=VALUE ...]: runs a case and prints, for each new mesh in the middle of a stage,
// the heat that leaves the glass to each partner in W on the state just before and just after, conducted and as light.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "forming/run/folder_run.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "tools/program/blas_threads.hpp"

namespace {

using namespace parison;

/// Heat out of the glass to a partner by one way, W.
struct Flow {
  std::string to;
  double rate;
};

std::vector<Flow> flows_of(const forming::Scene& scene, const forming::State& state) {
  const forming::HeatRates rates = forming::heat_rates(scene, state);
  std::vector<Flow> flows{{"air", rates.to_air}};
  if (scene.has_light()) flows.push_back({"surroundings, light", rates.light_to_air});
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const auto tool = static_cast<Eigen::Index>(t);
    flows.push_back({scene.tools[t].name, rates.conducted[tool]});
    if (scene.has_light()) flows.push_back({scene.tools[t].name + ", light", rates.radiated[tool]});
  }
  return flows;
}

/// Compares the state after each step with that from which the next one starts.
class RemeshHeat : public forming::RunObserver {
 public:
  void step_taken(const forming::RunView& run, const forming::State&, const forming::StepReport&) override {
    before_ = run.state;
  }
  void stage_begins(const forming::RunView&) override { before_.reset(); }
  void step_begins(const forming::RunView& run) override {
    if (!before_ || remeshes(*before_) == remeshes(run.state)) return;
    compare(run.scene.stages[run.state.stage].name, flows_of(run.scene, *before_), flows_of(run.scene, run.state));
    before_.reset();
  }

  int count() const { return count_; }
  double largest() const { return largest_; }
  double largest_of_partner() const { return largest_of_partner_; }

 private:
  void compare(const std::string& stage, const std::vector<Flow>& before, const std::vector<Flow>& after) {
    double all = 0, all_after = 0;
    for (const Flow& flow : before) all += flow.rate;
    for (const Flow& flow : after) all_after += flow.rate;
    ++count_;
    largest_ = std::max(largest_, std::abs(all_after / all - 1));
    std::string line = fmt::format("remesh {:.4f} s {:<8} all {:9.1f} W {:+.3f} %;", before_->time, stage, all,
                                   100 * (all_after / all - 1));
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double change = after[i].rate - before[i].rate;
      if (before[i].rate == 0 && change == 0) continue;
      largest_of_partner_ = std::max(largest_of_partner_, std::abs(change / all));
      line += fmt::format(" {} {:.1f} {:+.3f} %;", before[i].to, before[i].rate, 100 * change / before[i].rate);
    }
    std::printf("%s\n", line.c_str());
  }

  std::optional<forming::State> before_;
  int count_ = 0;
  double largest_ = 0, largest_of_partner_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "remesh_heat: CASE ACCURACY FOLDER [KEY=VALUE ...]\n");
    return 2;
  }
  tools::use_one_blas_thread();
  RemeshHeat rates;
  const std::vector<std::string> overrides(argv + 4, argv + argc);
  const auto outcome = forming::run_in_folder(forming::read_scene(argv[1], argv[2], overrides), argv[3], {&rates});
  if (!outcome.facts.completed) {
    std::fprintf(stderr, "remesh_heat: %s\n", outcome.facts.reason.c_str());
    return 1;
  }
  std::printf("%d new meshes in mid-stage; largest change of all heat %.3f %%, of a partner's %.3f %% of all\n",
              rates.count(), 100 * rates.largest(), 100 * rates.largest_of_partner());
  return 0;
}
