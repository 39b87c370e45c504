// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/idle/swabbed_tool.hpp"

#include <numeric>

#include "forming/step/heat/heat_step.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::forming {

SwabbedTool swabbed_tool(const Scene& scene, const State& state, Index tool) {
  const Swab& swab = *scene.tools[tool].swab;
  const core::Mesh& mesh = state.tools[tool].mesh;
  thermal::Problem problem{scene.geometry, {}, {}, {}};
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
  thermal::StepMatrix matrix;
  const Eigen::VectorXd uniform = Eigen::VectorXd::Constant(mesh.node_count(), scene.tools[tool].initial_temperature);
  auto outcome = thermal::advance(problem, 0, {uniform}, swab.seconds, heat_options(scene), matrix);
  const auto& through = outcome.balance.through_boundary;
  return {std::move(outcome.temperature.front()), std::accumulate(through.begin(), through.end(), 0.0),
          outcome.converged ? std::string() : outcome.reason};
}

}  // namespace parison::forming
