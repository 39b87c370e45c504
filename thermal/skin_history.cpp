// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/skin_history.hpp"

#include <algorithm>
#include <cmath>

#include "thermal/skin_error.hpp"

namespace parison::thermal {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Steps of an interval; their ends are at the third power of even shares, as a skin begins.
constexpr int steps_of_interval = 16;
/// Intervals shorter than this share of all time add no skin of their own.
constexpr double shortest_share = 1e-7;
/// A diagonal of a symmetric matrix and the two beside it.
using Band = Eigen::Matrix<double, 3, Eigen::Dynamic>;

Band band_of(const Eigen::MatrixXd& matrix) {
  Band band = Band::Zero(3, matrix.rows());
  for (Index i = 0; i < matrix.rows(); ++i)
    for (Index k = 0; k < 3 && i + k < matrix.rows(); ++k) band(k, i) = matrix(i, i + k);
  return band;
}

VectorXd times(const Band& band, const VectorXd& x) {
  VectorXd result = VectorXd::Zero(x.size());
  for (Index i = 0; i < x.size(); ++i) {
    result[i] += band(0, i) * x[i];
    for (Index k = 1; k < 3 && i + k < x.size(); ++k) {
      result[i] += band(k, i) * x[i + k];
      result[i + k] += band(k, i) * x[i];
    }
  }
  return result;
}

/// Solves with a positive definite matrix, by its factors L D L'.
VectorXd solve(Band band, VectorXd x) {
  const Index size = x.size();
  for (Index i = 0; i < size; ++i) {
    const double first = i + 1 < size ? band(1, i) / band(0, i) : 0,
                 second = i + 2 < size ? band(2, i) / band(0, i) : 0;
    if (i + 1 < size) {
      band(0, i + 1) -= first * band(1, i);
      band(1, i + 1) -= first * band(2, i);
      x[i + 1] -= first * x[i];
    }
    if (i + 2 < size) {
      band(0, i + 2) -= second * band(2, i);
      x[i + 2] -= second * x[i];
    }
    band(1, i) = first;
    band(2, i) = second;
  }
  for (Index i = size - 1; i >= 0; --i) {
    x[i] /= band(0, i);
    if (i + 1 < size) x[i] -= band(1, i) * x[i + 1];
    if (i + 2 < size) x[i] -= band(2, i) * x[i + 2];
  }
  return x;
}

/// Heat that has left through the surface, J/m2, at the ends of the intervals, and all without sign.
struct Heat {
  std::vector<double> given;
  double exchanged = 0;
};

/// A column that exchanges heat, integrated by the L-stable method of two stages (R. Alexander, SIAM J. Numer. Anal. 14
/// (1977) 1006-1021).
class CoolingColumn {
 public:
  explicit CoolingColumn(const SkinColumn& column)
      : stiffness_(band_of(column.stiffness)),
        mass_(band_of(column.mass)),
        temperature_(VectorXd::Zero(column.mass.rows())) {}

  void advance(const SkinLoad& middle, const SkinLoad& end, double dt, Heat& heat) {
    const VectorXd first = rate(temperature_, middle, diagonal * dt);
    const double early = flow(temperature_ + diagonal * dt * first, middle);
    temperature_ += (1 - diagonal) * dt * first;
    temperature_ += diagonal * dt * rate(temperature_, end, diagonal * dt);
    const double given = dt * ((1 - diagonal) * early + diagonal * flow(temperature_, end));
    given_ += given;
    heat.exchanged += std::abs(given);
  }
  double given() const { return given_; }

  inline static const double diagonal = 1 - 1 / std::sqrt(2.0);

 private:
  static double flow(const VectorXd& temperature, const SkinLoad& load) {
    return load.h * (temperature[0] - load.temperature);
  }
  /// Rate of change at the end of an implicit step of such a length from a temperature.
  VectorXd rate(const VectorXd& temperature, const SkinLoad& load, double step) const {
    Band matrix = mass_ + step * stiffness_;
    matrix(0, 0) += step * load.h;
    VectorXd power = -times(stiffness_, temperature);
    power[0] -= flow(temperature, load);
    return solve(std::move(matrix), std::move(power));
  }

  Band stiffness_, mass_;
  VectorXd temperature_;  ///< above that of the start, K
  double given_ = 0;
};

SkinLoad between(const SkinInterval& interval, double share) {
  const auto at = [&](double start, double end) { return start == end ? start : (1 - share) * start + share * end; };
  return {at(interval.start.h, interval.end.h), at(interval.start.temperature, interval.end.temperature)};
}

Heat heat_of(const SkinColumn& column, double start_temperature, const SkinHistory& history, double perfect) {
  CoolingColumn cooling(column);
  Heat heat;
  const auto load = [&](const SkinInterval& interval, double share) {
    const SkinLoad found = between(interval, share);
    return SkinLoad{std::min(found.h, perfect), found.temperature - start_temperature};
  };
  for (const SkinInterval& interval : history) {
    for (int step = 0; step < steps_of_interval; ++step) {
      const double from = std::pow(double(step) / steps_of_interval, 3),
                   to = std::pow(double(step + 1) / steps_of_interval, 3), dt = to - from;
      cooling.advance(load(interval, from + CoolingColumn::diagonal * dt), load(interval, to), dt * interval.duration,
                      heat);
    }
    heat.given.push_back(cooling.given());
  }
  return heat;
}

struct Times {
  double all = 0, shortest = 0;  ///< s
};

Times times_of(const SkinHistory& history) {
  Times times;
  for (const SkinInterval& interval : history) times.all += interval.duration;
  times.shortest = times.all;
  for (const SkinInterval& interval : history) times.shortest = std::min(times.shortest, interval.duration);
  times.shortest = std::max(times.shortest, shortest_share * times.all);
  return times;
}

/// A history and the heat that counts as exact.
class Reference {
 public:
  Reference(const SkinSide& side, double start_temperature, const SkinHistory& history)
      : history_(history), times_(times_of(history)), start_temperature_(start_temperature) {
    if (times_.all > 0) exact_ = heat(fine_side(side), std::min(side.first_cell, side.depth));
  }

  double error_of(const SkinSide& side) const {
    if (!(exact_.exchanged > 0)) return 0;
    const Heat found = heat(side, std::min(side.first_cell, side.depth));
    double error = 0;
    for (std::size_t i = 0; i < found.given.size(); ++i)
      error = std::max(error, std::abs(found.given[i] - exact_.given[i]));
    return error / exact_.exchanged;
  }
  double shortest() const { return times_.shortest; }

 private:
  Heat heat(const SkinSide& side, double thickness) const {
    return heat_of(skin_column(side, times_.all, times_.shortest), start_temperature_, history_,
                   perfect_conductance(side.conductivity, thickness));
  }

  const SkinHistory& history_;
  Times times_;
  double start_temperature_;
  Heat exact_;
};

}  // namespace

double skin_error(const SkinSide& side, double start_temperature, const SkinHistory& history) {
  return Reference(side, start_temperature, history).error_of(side);
}

double fitting_first_cell(const SkinSide& side, double start_temperature, const SkinHistory& history,
                          double tolerance) {
  constexpr double step = 0.8;     // from one cell that is tried to the next
  constexpr double small = 0.1;    // of the penetration depth: smaller ones always do
  constexpr int smaller_ones = 3;  // that have to do too: an error may change its sign
  const Reference exact(side, start_temperature, history);
  const double least = small * penetration(side, exact.shortest());
  SkinSide tried = side;
  double fitting = side.first_cell;
  for (int well = 0; tried.first_cell > least && well <= smaller_ones; tried.first_cell *= step) {
    if (exact.error_of(tried) <= tolerance) {
      if (well++ == 0) fitting = tried.first_cell;
    } else {
      well = 0;
      fitting = step * tried.first_cell;
    }
  }
  return fitting;
}

}  // namespace parison::thermal
