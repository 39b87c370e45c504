#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

namespace parison::flow {

/// ln eta over temperature through measured points: a cubic between each two, monotone because its slopes are those of
/// F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304. Beyond the points it goes on straight.
class ViscosityTable {
 public:
  /// ln eta and its derivative, 1/K.
  struct Value {
    double logarithm, derivative;
  };

  /// Points with rising temperatures, K, and falling viscosities, Pa.s; at least two.
  ViscosityTable(std::vector<double> temperature, const std::vector<double>& viscosity);

  Value operator()(double temperature) const;

  double coldest() const { return temperature_.front(); }  ///< of the points, K
  double hottest() const { return temperature_.back(); }
  /// By how much ln eta beyond the points is estimated to be wrong: against the law of Vogel, Fulcher and Tammann
  /// through the first, the middle and the last, or Arrhenius' law where they give none. Zero between the points.
  double error_beyond(double temperature) const;

 private:
  std::vector<double> temperature_;  ///< K
  std::vector<double> logarithm_;    ///< ln eta
  std::vector<double> slope_;        ///< d ln eta/dT at the points, 1/K
};

}  // namespace parison::flow
