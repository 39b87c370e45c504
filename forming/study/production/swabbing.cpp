// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/swabbing.hpp"

#include <algorithm>
#include <cmath>

#include "forming/step/heat/heat_step.hpp"
#include "forming/study/production/tool_fields.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::forming {
namespace {

/// The temperatures of a tool from which its contact surface gives off so much heat, J/m2, in that time, and nothing
/// else happens; from a uniform temperature. `heat` becomes the whole of it, J.
thermal::StepOutcome give_off(const Scene& scene, const State& state, Index tool, double& heat) {
  const Swab& swab = *scene.tools[tool].swab;
  const core::Mesh& mesh = state.tools[tool].mesh;
  thermal::Problem problem{scene.geometry, {}, {}, {}, scene.accuracy.temperature_order};
  problem.bodies.push_back(body_view(scene, state, body_of_tool(tool), mesh));
  // A given flux is exchange with something so cold, and so weak, that the surface's own temperature does not count.
  constexpr double weak = 1e-6;
  const double very_cold = -swab.heat / swab.seconds / weak;
  thermal::BodyView& body = problem.bodies.front();
  body.prescribed.clear();
  body.exchange.assign(mesh.boundaries().size(), std::nullopt);
  for (std::size_t i = 0; i < mesh.boundaries().size(); ++i)
    if (mesh.boundaries()[i].kind == BoundaryKind::contact)
      body.exchange[i] = thermal::SurfaceExchange{weak, very_cold, 0, 0};
  thermal::StepOptions options;
  options.tolerance = temperature_tolerance(scene);
  options.newton_tolerance = 1e-3 * options.tolerance;
  thermal::StepMatrix matrix;
  const Eigen::VectorXd uniform = Eigen::VectorXd::Constant(mesh.node_count(), scene.tools[tool].initial_temperature);
  auto outcome = thermal::advance(problem, 0, {uniform}, swab.seconds, options, matrix);
  heat = 0;
  for (const double through : outcome.balance.through_boundary) heat += through;
  return outcome;
}

/// Cycles from one swab to the next; 0 for a tool without.
int period(const SwabImprint& imprint, Eigen::Index node) {
  return imprint.share[node] > 0 ? static_cast<int>(std::lround(1 / imprint.share[node])) : 0;
}

int longest_period(const SwabImprint& imprint) {
  int longest = 0;
  for (Eigen::Index node = 0; node < imprint.share.size(); ++node) longest = std::max(longest, period(imprint, node));
  return longest;
}

}  // namespace

SwabImprint swab_imprint(const Scene& scene, const State& initial) {
  const Eigen::Index nodes = tool_temperatures(initial).size();
  SwabImprint imprint{Eigen::VectorXd::Zero(nodes), Eigen::VectorXd::Zero(nodes),
                      std::vector<double>(scene.tools.size(), 0), ""};
  Eigen::Index first = 0;
  for (std::size_t t = 0; t < scene.tools.size(); ++t) {
    const Eigen::Index size = initial.tools[t].temperature.size();
    if (scene.tools[t].swab && size > 0) {
      auto outcome = give_off(scene, initial, static_cast<Index>(t), imprint.heat[t]);
      if (!outcome.converged) imprint.failure = "the swab of " + scene.tools[t].name + ": " + outcome.reason;
      imprint.change.segment(first, size) = outcome.temperature.front().array() - scene.tools[t].initial_temperature;
      imprint.share.segment(first, size).setConstant(1.0 / scene.tools[t].swab->every);
    }
    first += size;
  }
  return imprint;
}

std::vector<Eigen::VectorXd> since_swab(const SwabImprint& imprint, const Eigen::VectorXd& settled,
                                        const CycleMap& next, double tolerance) {
  constexpr int most = 2000;
  const auto fixed = next(settled);
  if (!fixed) return {};
  // One swab alone, k cycles after it; its trace in the mean of production is what all that came before have left.
  std::vector<Eigen::VectorXd> traces{imprint.change};
  while (traces.back().lpNorm<Eigen::Infinity>() > 0.02 * tolerance && static_cast<int>(traces.size()) < most) {
    const auto later = next(settled + traces.back());
    if (!later) return {};
    traces.push_back(*later - *fixed);
  }
  const auto count = static_cast<int>(traces.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(settled.size());
  for (const Eigen::VectorXd& trace : traces) mean += trace.cwiseProduct(imprint.share);
  std::vector<Eigen::VectorXd> found;
  for (int k = 0; k < longest_period(imprint); ++k) {
    Eigen::VectorXd temperatures = settled - mean;
    for (Eigen::Index node = 0; node < settled.size(); ++node)
      if (const int every = period(imprint, node); every > 0)
        for (int m = k % every; m < count; m += every) temperatures[node] += traces[m][node];
    found.push_back(std::move(temperatures));
  }
  return found;
}

}  // namespace parison::forming
