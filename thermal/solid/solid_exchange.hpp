#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_system.hpp"

namespace parison::thermal {

/// Adds a body's faces that exchange heat with the air.
void add_faces(SolidSystem& system, Index body);
/// Adds the pairs of faces in contact.
void add_contacts(SolidSystem& system);

/// Adds the exchange with the air and across the interface to power and flows.
void add_exchange(const SolidSystem& system, double time, const Eigen::VectorXd& temperature, Response& response);

/// The step times the symmetric positive part of the derivative of that exchange, J/K, as dense matrices, row-major,
/// of which the lower triangle counts: calls face(clique, unknowns, matrix) with 9 unknowns, contact(pair, unknowns,
/// matrix) with 18.
struct ExchangeMatrices {
  std::function<void(Index clique, const std::array<Index, 9>& unknowns, std::array<double, 81>& matrix)> face;
  std::function<void(Index pair, const std::array<Index, 18>& unknowns, std::array<double, 324>& matrix)> contact;
};
void for_each_exchange_matrix(const SolidSystem& system, double time, const Eigen::VectorXd& temperature, double step,
                              const ExchangeMatrices& add);

}  // namespace parison::thermal
