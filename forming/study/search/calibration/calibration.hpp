#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "forming/study/search/case/search_case.hpp"
#include "forming/study/search/case/search_variable.hpp"
#include "forming/study/search/outcome.hpp"

namespace parison::forming {

/// A constant that a fit has found, in the unit of its bounds.
struct FittedConstant {
  double value, low, high;  ///< the 95 % interval; not a number where the data cannot tell
  bool at_bound;
};

/// What a fit says of its constants.
struct FitIntervals {
  std::vector<FittedConstant> constants;
  double scatter = 0;               ///< of the data about the model, in units of the stated noise
  long freedom = 0;                 ///< rows less constants
  std::vector<std::string> cannot;  ///< sentences on directions that the data cannot tell
};

/// The 95 % intervals of constants by the linearised covariance s^2 (J^T J)^-1 and Student's t. A direction in which
/// the data let the constants move by more than their bounds are apart, the data cannot tell: it is named and left out
/// of the intervals of the others. `residual` in units of the noise, a row a measurement, and `jacobian` its derivative
/// by the coordinates at the optimum.
FitIntervals fit_intervals(const std::vector<SearchVariable>& variables, const Eigen::VectorXd& at,
                           const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian);

/// Measurements of one kind: a thermocouple, a tool's place or its force over time, or the wall over its arc or height.
struct MeasuredCurve {
  std::string file;
  std::string column;         ///< of history.csv, such as couple_degC; empty for the wall
  bool over_arc = false;      ///< the wall
  std::vector<double> at;     ///< s; mm
  std::vector<double> value;  ///< degC; mm; N
  double noise;               ///< standard deviation, K; mm; N
  /// Of the wall of a container in space: the plane through the axis, one of solid/meridians.csv, deg.
  std::optional<double> angle = {};

  std::string name() const;
};

/// What is fitted, and to what.
struct CalibrationCase : SearchCase {
  std::vector<MeasuredCurve> curves;
};

struct CalibrationNoise {
  double temperature = 1;   ///< K
  double thickness = 0.05;  ///< mm
  double position = 0.1;    ///< mm
  double force = 10;        ///< N
};

/// Reads tables with the columns time_s and PROBE_degC, TOOL_position_mm, TOOL_force_N, or thickness_mm and arc_mm or
/// z_mm; where the glass becomes a body in space the wall has angle_deg too, and what is over time ends there. Throws
/// core::CaseError with file and line where a column, a name or a number is wrong, or a time is after the
/// end of the case. Columns of other names are left out.
std::vector<MeasuredCurve> read_measurements(const std::string& path, const Scene& scene,
                                             const CalibrationNoise& noise);

/// The variables of "KEY=FROM to TO": by their logarithms where both bounds are above zero and no temperatures.
std::vector<SearchVariable> varied_constants(const std::vector<std::string>& texts, const std::string& case_path,
                                             const std::vector<std::string>& overrides, bool with_flow);

/// What a run gives at the places of a curve; nothing where it lacks it.
std::optional<std::vector<double>> model_at(const MeasuredCurve& curve, const std::string& folder);

/// Model less measurement of all curves, in units of their noise.
std::optional<Eigen::VectorXd> misfit(const std::vector<MeasuredCurve>& curves, const std::string& folder);

}  // namespace parison::forming
