// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/sealed_air.hpp"

#include "core/solid/hex_geometry.hpp"
#include "forming/flow/air/air_balance.hpp"

namespace parison::flow {

namespace {

void add(const std::array<Index, 9>& nodes, const Eigen::Matrix<double, 3, 9>& force, Eigen::Ref<Eigen::VectorXd> to) {
  for (int n = 0; n < 9; ++n) to.segment<3>(3 * nodes[n]) += force.col(n);
}

}  // namespace

SealedAir::SealedAir(const SolidProblem& problem, const HexMesh& middle) : air_(&*problem.air) {
  const auto pockets = static_cast<Index>(air_->pockets.size());
  const Index rows = 3 * middle.node_count();
  sweep_ = Eigen::MatrixXd::Zero(rows, pockets);
  suction_ = Eigen::VectorXd::Zero(rows);
  by_tools_ = pressure_ = Eigen::VectorXd::Zero(pockets);
  for (std::size_t f = 0; f < problem.contact_faces.size(); ++f) {
    const Index behind = air_->behind[f];
    if (behind == open_air) continue;
    const HexFace& face = problem.contact_faces[f];
    const auto nodes = core::face_node_numbers(middle, face);
    std::size_t index = f * contact_points_per_face;
    for (const auto& at : core::map_hex_face(core::face_nodes(middle, face), face, contact_points_along)) {
      const Eigen::Matrix<double, 3, 9> force = -at.area * at.normal * at.shape.transpose();
      loads_.push_back({index++, behind, nodes, force});
      if (behind >= 0) add(nodes, force, sweep_.col(behind));  // glass that moves outwards takes the air's room
    }
  }
  for (Index j = 0; j < pockets; ++j) {
    const AirPocket& pocket = air_->pockets[static_cast<std::size_t>(j)];
    pressure_[j] = pocket.energy / pocket.volume - air_->ambient;
    by_tools_[j] = problem.air->tool_rate[static_cast<std::size_t>(j)];
  }
}

void SealedAir::expose(const std::vector<bool>& touches, const FlowMatrix& matrix) {
  unit_ = Eigen::MatrixXd::Zero(sweep_.rows(), sweep_.cols());
  response_ = unit_;
  suction_.setZero();
  for (const Load& load : loads_) {
    if (touches[load.point]) continue;
    if (load.behind >= 0)
      add(load.nodes, load.force, unit_.col(load.behind));
    else
      add(load.nodes, -air_->ambient * load.force, suction_);
  }
  for (Index j = 0; j < unit_.cols(); ++j) response_.col(j) = matrix.response(unit_.col(j));
}

Eigen::VectorXd SealedAir::volume_rates(const Eigen::VectorXd& velocity) const {
  return sweep_.transpose() * velocity + by_tools_;
}

Eigen::VectorXd SealedAir::balanced(const Eigen::VectorXd& without) {
  const auto pockets = static_cast<Index>(sweep_.cols());
  if (pockets == 0) return without;
  AirResponse response{air_, Eigen::MatrixXd(pockets, 1 + pockets)};
  response.rate.col(0) = volume_rates(without);
  response.rate.rightCols(pockets) = sweep_.transpose() * response_;
  pressure_ = AirBalance{response, Eigen::MatrixXd(0, pockets), Eigen::VectorXd(0)}.solve(pressure_);
  return without + response_ * pressure_;
}

std::vector<AirPocketEnd> SealedAir::ends(const Eigen::VectorXd& velocity) const {
  const Eigen::VectorXd rates = volume_rates(velocity);
  std::vector<AirPocketEnd> ends;
  for (Index j = 0; j < rates.size(); ++j) {
    const AirPocket& pocket = air_->pockets[static_cast<std::size_t>(j)];
    const double inside = pressure_[j] + air_->ambient;
    ends.push_back({pocket.volume + air_->dt * rates[j],
                    pocket.vent > 0 ? air_->dt * vent_outflow(pocket.vent, inside, air_->ambient).value : 0});
  }
  return ends;
}

}  // namespace parison::flow
