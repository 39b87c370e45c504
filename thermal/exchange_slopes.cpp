// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/linearise.hpp"
#include "thermal/step_matrix.hpp"

namespace parison::thermal {

namespace {

ContactSlopes linearise_contact(const HeatSystem& system, const Eigen::VectorXd& temperature) {
  const HeatInterface& interface = system.interface;
  if (interface.segments.empty()) return {};
  const auto [T1, T2] = side_temperatures(interface, temperature);
  Eigen::ArrayXd h(T1.size()), dh_dT(T1.size());
  system.problem->law(system.problem->interface, T1, h, &dh_dT);
  return {interface.area * h, interface.area * dh_dT * (T1 - T2), interface.slave_air.slope(T1),
          interface.master_air.slope(T2)};
}

void add_edges(StepMatrix& matrix, const HeatSystem& system, const Linearisation& slopes, double step) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    std::array<double, 9> local{};
    for (int q = 0; q < 3; ++q)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
          local[i * 3 + j] += step * slopes.edges[e][q] * edge.shape[q][i] * edge.shape[q][j];
    const Index clique = static_cast<Index>(system.cells.size()) + edge.boundary_edge;
    add_clique(matrix, system, clique, 3, edge.unknowns.data(), local.data());
  }
}

/// The points of a segment share their clique: one entry in the matrix for all of them.
void add_segments(StepMatrix& matrix, const HeatSystem& system, const ContactSlopes& slopes, double step) {
  using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
  const Eigen::ArrayXd across = step * slopes.across;
  const Eigen::ArrayXd slave = step * (slopes.across + slopes.conductance.max(0) - slopes.slave_air);
  const Eigen::ArrayXd master = step * (slopes.across - slopes.master_air);
  for (std::size_t k = 0; k < system.interface.segments.size(); ++k) {
    const HeatSegment& segment = system.interface.segments[k];
    RowMajor local = RowMajor::Zero();
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      const Eigen::Vector3d s = system.interface.shape.col(i).head<3>(), m = system.interface.shape.col(i).tail<3>();
      local.topLeftCorner<3, 3>() += slave[i] * s * s.transpose();
      local.bottomLeftCorner<3, 3>() -= across[i] * m * s.transpose();
      local.bottomRightCorner<3, 3>() += master[i] * m * m.transpose();
    }
    add_clique(matrix, system, matrix.segment_clique[k], 6, segment.unknowns.data(), local.data());
  }
}

}  // namespace

void linearise_exchange(const HeatSystem& system, const Eigen::VectorXd& temperature, Linearisation& result) {
  for (const HeatEdge& edge : system.edges) {
    auto& slopes = result.edges.emplace_back();
    for (int q = 0; q < 3; ++q) {
      const double T = interpolate(temperature, edge.unknowns.data(), edge.shape[q]);
      slopes[q] = edge.area[q] * surface_flux(edge.exchange, T).dq_dT;
    }
  }
  result.contacts = linearise_contact(system, temperature);
}

void apply_exchange(const HeatSystem& system, const Linearisation& linearisation, double step,
                    const Eigen::VectorXd& change, Eigen::VectorXd& result) {
  for (std::size_t e = 0; e < system.edges.size(); ++e) {
    const HeatEdge& edge = system.edges[e];
    for (int q = 0; q < 3; ++q) {
      const double heat =
          step * linearisation.edges[e][q] * interpolate(change, edge.unknowns.data(), edge.shape[q]);
      for (int i = 0; i < 3; ++i) result[edge.unknowns[i]] += edge.shape[q][i] * heat;
    }
  }
  if (system.interface.segments.empty()) return;
  const auto [d1, d2] = side_temperatures(system.interface, change);
  const ContactSlopes& slopes = linearisation.contacts;
  const Eigen::ArrayXd across = step * (slopes.across * (d1 - d2) + slopes.conductance * d1);
  const Eigen::ArrayXd slave = across - step * slopes.slave_air * d1, master = -across - step * slopes.master_air * d2;
  for (const HeatSegment& segment : system.interface.segments) {
    Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
    for (Index i = segment.first_point; i < segment.last_point; ++i) {
      out.head<3>() += slave[i] * system.interface.shape.col(i).head<3>();
      out.tail<3>() += master[i] * system.interface.shape.col(i).tail<3>();
    }
    scatter<6>(out, segment.unknowns, result);
  }
}

void assemble_exchange(StepMatrix& matrix, const HeatSystem& system, const Eigen::VectorXd& temperature, double step) {
  Linearisation slopes;
  linearise_exchange(system, temperature, slopes);
  add_edges(matrix, system, slopes, step);
  if (!system.interface.segments.empty()) add_segments(matrix, system, slopes.contacts, step);
}

}  // namespace parison::thermal
