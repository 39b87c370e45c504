// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light_error.hpp"

#include "thermal/system.hpp"

namespace parison::thermal {

LightError light_error(Problem problem, double time, const std::vector<Eigen::VectorXd>& temperature) {
  constexpr int parts = 4;
  Eigen::ArrayXd mean, squares;
  for (int part = 0; part < parts; ++part) {
    problem.light_resolution.part = {parts, part};
    const HeatSystem system = make_heat_system(problem);
    const Flows found = evaluate_flows(system, time, join(system, temperature));
    Eigen::ArrayXd flows(found.to_air.size() + found.across.size());
    flows << found.to_air.array(), found.across.array();
    if (part == 0) mean = squares = Eigen::ArrayXd::Zero(flows.size());
    mean += flows / parts;
    squares += flows.square() / parts;
  }
  const Eigen::ArrayXd variance = (squares - mean.square()).max(0) * parts / (parts - 1.0);
  return {variance.sqrt().sum(), mean.abs().sum()};
}

}  // namespace parison::thermal
