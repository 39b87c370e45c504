#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cmath>

namespace parison::core {

/// A number with its derivative, for forward-mode differentiation (Griewank and Walther 2008, Evaluating Derivatives,
/// chapter 3): a law that is a template on its number gives its value for doubles and arrays, and its exact derivative
/// as well for dual numbers of either. `Derivative` is a vector where there are several variables.
template <typename Value, typename Derivative = Value>
struct Dual {
  Value value;
  Derivative derivative;

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.derivative + b.derivative}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.derivative - b.derivative}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.value * b.derivative + b.value * a.derivative};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Value quotient = a.value / b.value;
    return {quotient, (a.derivative - quotient * b.derivative) / b.value};
  }
  friend Dual operator+(double a, const Dual& b) { return {a + b.value, b.derivative}; }
  friend Dual operator-(const Dual& a, double b) { return {a.value - b, a.derivative}; }
  friend Dual operator*(double a, const Dual& b) { return {a * b.value, a * b.derivative}; }
  friend Dual operator/(const Dual& a, double b) { return {a.value / b, a.derivative / b}; }
  friend Dual operator/(double a, const Dual& b) {
    const Value quotient = a / b.value;
    return {quotient, -(quotient / b.value) * b.derivative};
  }
};

template <typename Value, typename Derivative>
Dual<Value, Derivative> exp(const Dual<Value, Derivative>& x) {
  using std::exp;
  const Value result = exp(x.value);
  return {result, result * x.derivative};
}

template <typename Value, typename Derivative>
Dual<Value, Derivative> log(const Dual<Value, Derivative>& x) {
  using std::log;
  return {log(x.value), x.derivative / x.value};
}

/// A number, or the value of a dual number.
template <typename Number>
const Number& value_of(const Number& x) {
  return x;
}
template <typename Value, typename Derivative>
const Value& value_of(const Dual<Value, Derivative>& x) {
  return x.value;
}

/// A number of the same kind and size as `x` with this value everywhere and no derivative.
inline double constant_like(double, double value) {
  return value;
}
template <typename Array>
typename Array::PlainObject constant_like(const Eigen::ArrayBase<Array>& x, double value) {
  return Array::PlainObject::Constant(x.rows(), x.cols(), value);
}
template <typename Value, typename Derivative>
Dual<Value, Derivative> constant_like(const Dual<Value, Derivative>& x, double value) {
  return {constant_like(x.value, value), constant_like(x.derivative, 0)};
}

/// The smaller of a number and a bound; where that is the bound the derivative is zero.
inline double min(double x, double bound) {
  return x < bound ? x : bound;
}
template <typename Array>
auto min(const Eigen::ArrayBase<Array>& x, double bound) {
  return x.min(bound);
}
template <typename Value, typename Derivative>
Dual<Value, Derivative> min(const Dual<Value, Derivative>& x, double bound) {
  return x.value < bound ? x : constant_like(x, bound);
}

/// A number where the condition holds, elsewhere a constant; entry by entry for arrays.
template <typename Number>
Number choose(bool condition, const Number& x, double otherwise) {
  return condition ? x : constant_like(x, otherwise);
}
template <typename Condition, typename Array>
auto choose(const Eigen::ArrayBase<Condition>& condition, const Eigen::ArrayBase<Array>& x, double otherwise) {
  return condition.select(x, otherwise);
}

}  // namespace parison::core
