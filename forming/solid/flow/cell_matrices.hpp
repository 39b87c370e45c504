#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "core/solid/hex_element.hpp"
#include "forming/solid/flow/solid_problem.hpp"

namespace parison::flow {

inline constexpr int hex_unknowns = 81;  ///< velocities of a cell: component + 3 node
using HexMatrix = Eigen::Matrix<double, hex_unknowns, hex_unknowns, Eigen::RowMajor>;
using CellVector = Eigen::Matrix<double, hex_unknowns, 1>;
using CellDivergence = Eigen::Matrix<double, 4, hex_unknowns, Eigen::RowMajor>;

/// What a cell adds to the balance of forces, with its velocities v and pressures p.
struct HexMatrices {
  HexMatrix viscous;                 ///< int 2 eta D(u):D(v) dV, of glass with a memory of the deviators, Pa.s.m
  CellDivergence divergence;         ///< int q div v dV for the four pressure functions q, m2
  Eigen::Matrix4d mass;              ///< int q q' dV, m3
  Eigen::Vector4d moment;            ///< int q dV, m3
  core::HexShape share;              ///< of each node in the volume
  double mean_viscosity = 0;         ///< over its volume, Pa.s
  CellVector memory_force;           ///< -int s:D(u) dV of the deviator s that glass remembers, N
  Eigen::Vector4d memory_expansion;  ///< int q e dV of its expansion rate e, m3/s
};

/// What a cell has at its nodes, one a column.
struct CellState {
  core::HexNodes nodes;        ///< m
  core::HexShape temperature;  ///< K
  core::HexNodes velocity;     ///< m/s: by it glass thins that thins by shear
  Index number = 0;            ///< of the cell, for what glass remembers
};

/// The Gauss rule across the wall has the more points the more the viscosity differs there.
void compute_cell(const SolidProblem& problem, const CellState& cell, HexMatrices& result);

}  // namespace parison::flow
