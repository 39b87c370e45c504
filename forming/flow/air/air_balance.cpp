// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/air/air_balance.hpp"

#include <Eigen/LU>

#include "forming/flow/problem.hpp"

namespace parison::flow {

AirResponse air_response(const Problem& problem, const AirLoads& loads, const Eigen::MatrixXd& columns,
                         const std::vector<Index>& driven) {
  const TrappedAir& air = *problem.air;
  AirResponse response{&air, loads.sweep.transpose() * columns.topRows(loads.sweep.rows())};
  for (Index j = 0; j < response.pockets(); ++j) {
    const auto& area = air.pockets[j].tool_area;
    for (std::size_t t = 0; t < problem.tools.size(); ++t)
      if (!problem.tools[t].force) response.rate(j, 0) += area[t] * problem.tools[t].velocity;
    for (std::size_t k = 0; k < driven.size(); ++k) response.rate(j, 1 + Index(k)) += area[driven[k]];
  }
  return response;
}

Eigen::VectorXd AirBalance::solve(Eigen::VectorXd unknowns) const {
  constexpr int max_iterations = 200;
  const TrappedAir& air = *response.air;
  const Index tools = Index(rhs.size()), pockets = response.pockets(), all = tools + pockets;
  Eigen::MatrixXd jacobian(all, all);
  Eigen::VectorXd defect(all);
  jacobian.topRows(tools) = resistance;
  for (int i = 0; i < max_iterations; ++i) {
    defect.head(tools) = resistance * unknowns - rhs;
    for (Index j = 0; j < pockets; ++j) {
      const Eigen::RowVectorXd row = air.dt * response.rate.row(j).tail(all);
      const double volume = air.pockets[j].volume + air.dt * response.rate(j, 0) + row.dot(unknowns);
      const auto law = pressure_at(air.pockets[j], air.ambient, air.dt, volume);
      defect[tools + j] = unknowns[tools + j] + air.ambient - law.value;
      jacobian.row(tools + j) = -law.slope * row;
      jacobian(tools + j, tools + j) += 1;
    }
    const Eigen::VectorXd change = jacobian.partialPivLu().solve(defect);
    unknowns -= change;
    const auto small = [](const auto& part, double scale) { return part.template lpNorm<Eigen::Infinity>() <= scale; };
    if (!(change.allFinite()) || (small(change.tail(pockets), 1e-12 * air.ambient) &&
                                  small(change.head(tools), 1e-12 * unknowns.head(tools).lpNorm<Eigen::Infinity>())))
      break;
  }
  return unknowns;
}

}  // namespace parison::flow
