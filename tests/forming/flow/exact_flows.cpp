// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_flows.hpp"

#include <Eigen/Dense>
#include <complex>

namespace parison::flow {

namespace {

/// Velocity (U cos ky, V sin ky), pressure P cos ky, stresses S cos ky (xx) and T sin ky (xy), with dV/dx.
struct CxMode {
  long double U, V, P, S, T, derivative;
};

/// U = e^{kx}, x e^{kx}, e^{-kx}, x e^{-kx} solve the flow without force; V = -U'/k, P' = eta (U'' - k^2 U).
CxMode cx_mode(int which, long double x, long double k, long double eta) {
  const long double s = which < 2 ? k : -k, e = std::exp(s * x);
  const bool linear = which % 2 == 1;
  const long double U = linear ? x * e : e, dU = linear ? (1 + s * x) * e : s * e;
  const long double ddU = linear ? (2 * s + s * s * x) * e : s * s * e;
  const long double V = -dU / k, derivative = -ddU / k, P = linear ? 2 * eta * e : 0;
  return {U, V, P, 2 * eta * dU - P, eta * (derivative - k * U), derivative};
}

/// Answer to the force: U = a sin kx with a = -1/(4 eta k^2).
CxMode cx_forced(long double x, long double k, long double eta) {
  const long double a = -1 / (4 * eta * k * k), s = std::sin(k * x), c = std::cos(k * x);
  const long double P = 2 * eta * k * a * c;
  return {a * s, -a * c, P, 2 * eta * a * k * c - P, eta * (a * k * s - k * a * s), a * k * s};
}

}  // namespace

ExactFlow sol_cx(double jump) {
  using Matrix = Eigen::Matrix<long double, 8, 8>;
  const long double k = M_PIl;
  const std::array<long double, 2> eta{1.0L, jump};
  Matrix conditions = Matrix::Zero();
  Eigen::Matrix<long double, 8, 1> rhs;
  const auto fill = [&](int side, int column, const CxMode& wall, const CxMode& middle, long double scale) {
    const int sign = side == 0 ? 1 : -1;
    const std::array<long double, 6> rows{wall.U,          wall.derivative, middle.U * sign,
                                          middle.V * sign, middle.S * sign, middle.T * sign};
    for (int i = 0; i < 6; ++i) {
      const int row = i < 2 ? 2 * side + i : 2 + i;
      if (column < 8)
        conditions(row, column) = rows[i] / scale;
      else
        rhs[row] -= rows[i];
    }
  };
  rhs.setZero();
  for (int side = 0; side < 2; ++side) {
    const long double wall = side;
    for (int m = 0; m < 4; ++m)
      fill(side, 4 * side + m, cx_mode(m, wall, k, eta[side]), cx_mode(m, 0.5L, k, eta[side]), eta[side]);
    fill(side, 8, cx_forced(wall, k, eta[side]), cx_forced(0.5L, k, eta[side]), 1);
  }
  const Eigen::Matrix<long double, 8, 1> c = conditions.fullPivLu().solve(rhs);
  const auto at = [=](double x) {
    const int side = x < 0.5 ? 0 : 1;
    CxMode sum = cx_forced(x, k, eta[side]);
    for (int m = 0; m < 4; ++m) {
      const CxMode mode = cx_mode(m, x, k, eta[side]);
      const long double weight = c[4 * side + m] / eta[side];
      sum.U += weight * mode.U, sum.V += weight * mode.V, sum.P += weight * mode.P;
    }
    return sum;
  };
  return {[=](const Point& x) -> Point {
            const CxMode mode = at(x[0]);
            return {double(mode.U) * std::cos(M_PI * x[1]), double(mode.V) * std::sin(M_PI * x[1])};
          },
          [=](const Point& x) { return double(at(x[0]).P) * std::cos(M_PI * x[1]); }};
}

ExactFlow sol_kz(double ratio) {
  // v = (U sin kx, W cos kx); stresses over the viscosity: s cos kx (yy), t sin kx (xy). y = (W, U, s, t):
  // W' = -k U, U' = t + k W, s' = -k t - 2B s - sin(2y)/eta, t' = 4 k^2 U + k s - 2B t; W = t = 0 at both walls.
  using Complex = std::complex<double>;
  const double k = 3 * M_PI, growth = std::log(ratio);
  Eigen::Matrix4d flow;
  flow << 0, -k, 0, 0, k, 0, 0, 1, 0, 0, -growth, -k, 0, 4 * k * k, k, -growth;
  const Eigen::EigenSolver<Eigen::Matrix4d> modes(flow);
  const Eigen::Vector4cd rate = modes.eigenvalues();
  const Eigen::Matrix4cd shape = modes.eigenvectors();
  const Complex forcing(-growth, 2);  // sin(2y)/eta = Im e^{forcing y}
  const Eigen::Matrix4cd shifted = forcing * Eigen::Matrix4cd::Identity() - flow.cast<Complex>();
  const Eigen::Vector4cd forced = shifted.fullPivLu().solve(Eigen::Vector4cd(-Eigen::Vector4cd::Unit(2)));
  const auto amplitude = [=](int m, double y) { return std::exp(rate[m] * (rate[m].real() > 0 ? y - 1 : y)); };
  const auto forced_at = [=](double y) -> Eigen::Vector4d { return (forced * std::exp(forcing * y)).imag(); };
  Eigen::Matrix4cd walls;
  Eigen::Vector4cd rhs;
  for (int i = 0; i < 4; ++i) {
    const double y = i / 2;
    const int part = i % 2 == 0 ? 0 : 3;
    for (int m = 0; m < 4; ++m) walls(i, m) = shape(part, m) * amplitude(m, y);
    rhs[i] = -forced_at(y)[part];
  }
  const Eigen::Vector4cd c = walls.fullPivLu().solve(rhs);
  const auto at = [=](double y) {
    Eigen::Vector4d sum = forced_at(y);
    for (int m = 0; m < 4; ++m) sum += (c[m] * amplitude(m, y) * shape.col(m)).real();
    return sum;
  };
  return {[=](const Point& x) -> Point {
            const Eigen::Vector4d y = at(x[1]);
            return {y[1] * std::sin(k * x[0]), y[0] * std::cos(k * x[0])};
          },
          [=](const Point& x) {
            const Eigen::Vector4d y = at(x[1]);
            return -std::exp(growth * x[1]) * (2 * k * y[1] + y[2]) * std::cos(k * x[0]);
          }};
}

ExactFlow sol_vi(double jump, double radius) {
  using Complex = std::complex<double>;
  const double contrast = (jump - 1) / (jump + 1), square = radius * radius;
  return {[=](const Point& x) -> Point {
            const Complex z(x[0], x[1]), bar = std::conj(z);
            Complex v = 2 / (1 + jump) * bar;
            if (std::norm(z) > square)
              v = bar - contrast * square * (1.0 / z + z / (bar * bar) - square / (bar * bar * bar));
            return {v.real(), v.imag()};
          },
          [=](const Point& x) {
            const Complex z(x[0], x[1]);
            return std::norm(z) > square ? -4 * contrast * square * (1.0 / (z * z)).real() : 0.0;
          }};
}

}  // namespace parison::flow
